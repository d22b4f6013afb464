#include "cli/chart_measure.h"

#include <fmt/format.h>

#include "base/error.h"
#include "chart/false_color.h"
#include "cli/commands.h"
#include "cli/stats_json.h"
#include "cli/timed_frames.h"
#include "image/image_io.h"
#include "image/metrics.h"
#include "reference/piece_count.h"

namespace tetralux::cli {
namespace {

// Frames end after so long: with large images a few tell as much as many.
constexpr double kLimitSeconds = 2.0;

std::string milliseconds(double ms) { return fmt::format("{:.3f}", ms); }

// Digits enough to tell any two numbers apart.
std::string exactNumber(double value) { return fmt::format("{}", value); }

void addErrors(const ImageDifference& difference, chart::CsvRow& row) {
  row["rmse"] = exactNumber(difference.rmse);
  row["max"] = exactNumber(difference.max);
  row["p99"] = exactNumber(difference.p99);
  row["mean"] = exactNumber(difference.mean);
  row["flip"] = exactNumber(difference.flip);
  row["non_finite"] = fmt::format("{}", difference.nonFinite);
}

void addTimes(const nlohmann::ordered_json& stats, chart::CsvRow& row) {
  const auto time = [&](const std::string& name) { return stats["ms"][name].get<double>(); };
  row["frames"] = fmt::format("{}", stats["frames"].get<size_t>());
  row["ms_frame"] = milliseconds(time("frame"));
  for (const std::string& pass : passNames()) row["ms_" + pass] = milliseconds(time(pass));
  row["ms_readback"] = milliseconds(time("readback"));
  const double framesPerSecond = 1e3 / time("frame");
  row["fps"] = fmt::format("{:.3f}", framesPerSecond);
  row["tets_per_s"] = fmt::format("{:.0f}", framesPerSecond * stats["tets"].get<double>());
}

void addCounts(const nlohmann::ordered_json& stats, chart::CsvRow& row) {
  row["drawn_order"] = stats["order"].get<std::string>();
  row["drawn_target"] = stats["target"].get<std::string>();
  row["drawn_tets"] = fmt::format("{}", stats["drawn_tets"].get<std::uint64_t>());
  row["ms_tables"] = milliseconds(stats["ms"]["tables"].get<double>());
  for (const char* part : {"mesh", "frame", "order", "tables"})
    row[std::string("bytes_") + part] = fmt::format("{}", stats["bytes"][part].get<std::uint64_t>());
}

}  // namespace

const std::vector<std::string>& measurementColumns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> list = {"key", "kind", "scene", "mesh", "cells", "width", "height", "configuration"};
    for (const std::string& key : Configuration::keys()) list.push_back(key);
    for (const char* name : {"drawn_order", "drawn_target", "drawn_tets", "rmse", "max", "p99", "mean", "flip",
                             "non_finite", "frames", "fps", "tets_per_s", "ms_frame"})
      list.emplace_back(name);
    for (const std::string& pass : passNames()) list.push_back("ms_" + pass);
    for (const char* name : {"ms_readback", "ms_tables", "bytes_mesh", "bytes_frame", "bytes_order", "bytes_tables",
                             "cell_pieces", "segments", "pieces", "device", "driver", "version", "note"})
      list.emplace_back(name);
    return list;
  }();
  return columns;
}

ChartMeasurer::ChartMeasurer(const gpu::Context& context, std::filesystem::path pictures, std::uint32_t frames)
    : context_(context), pictures_(std::move(pictures)), frames_(frames) {}

void ChartMeasurer::setScene(const ChartScene& scene, LoadedChartScene& loaded) {
  renderer_.reset();
  rendererText_.clear();
  scene_ = &scene;
  loaded_ = &loaded;
}

ImageSize ChartMeasurer::sizeOf(const Measurement& measurement) const {
  return measurement.side > 0 ? ImageSize{measurement.side, measurement.side} : loaded_->loaded().scene.size;
}

std::string ChartMeasurer::key(const Measurement& measurement) const {
  const ImageSize size = sizeOf(measurement);
  return contentHash(fmt::format("{}|{}|{}|{}|{}x{}|{}|{}|{}|{}", measurementKindName(measurement.kind), scene_->name,
                                 loaded_->hash(), measurement.configuration.text(), size.width, size.height, frames_,
                                 context_.info().name, context_.info().driver, versionString()));
}

std::vector<std::string> ChartMeasurer::pictureFiles(const Measurement& measurement) const {
  if (measurement.kind != MeasurementKind::Picture) return {};
  const std::string stem = fmt::format("{}-{}", scene_->name, key(measurement));
  return {stem + ".png", stem + "-difference.png"};
}

chart::CsvRow ChartMeasurer::identity(const Measurement& measurement) const {
  const ImageSize size = sizeOf(measurement);
  chart::CsvRow row;
  row["key"] = key(measurement);
  row["kind"] = measurementKindName(measurement.kind);
  row["scene"] = scene_->name;
  row["mesh"] = loaded_->loaded().scene.meshPath.filename().string();
  row["cells"] = fmt::format("{}", loaded_->loaded().mesh.cellCount());
  row["width"] = fmt::format("{}", size.width);
  row["height"] = fmt::format("{}", size.height);
  row["device"] = context_.info().name;
  row["driver"] = context_.info().driver;
  row["version"] = versionString();
  if (measurement.kind == MeasurementKind::Segments) return row;
  row["configuration"] = measurement.configuration.name();
  for (const std::string& name : Configuration::keys()) row[name] = measurement.configuration.value(name);
  return row;
}

chart::CsvRow ChartMeasurer::measure(const Measurement& measurement) {
  chart::CsvRow row = identity(measurement);
  if (measurement.kind == MeasurementKind::Segments) {
    measureSegments(row);
    return row;
  }
  try {
    draw(measurement, row);
  } catch (const Error& e) {
    // The renderer says so of methods that do not go together, or with the scene; all else is a failure.
    if (e.code() != ErrorCode::Usage && e.code() != ErrorCode::Input) throw;
    row["note"] = e.what();
  }
  return row;
}

void ChartMeasurer::measureSegments(chart::CsvRow& row) {
  const LoadedScene& loaded = loaded_->loaded();
  const ExactPicture& exact = loaded_->exactPicture();
  row["cell_pieces"] =
      fmt::format("{}", reference::cellPieceCount(loaded.mesh, loaded.field, loaded.scene.transferFunction));
  row["segments"] = fmt::format("{}", exact.segments);
  row["pieces"] = fmt::format("{}", exact.pieces);
}

render::Renderer& ChartMeasurer::rendererFor(const Configuration& configuration) {
  if (renderer_ && rendererText_ == configuration.rendererText()) return *renderer_;
  const LoadedScene& loaded = loaded_->loaded();
  renderer_.reset();  // its memory first
  renderer_ = std::make_unique<render::Renderer>(context_, loaded.mesh, loaded.field,
                                                 configuration.deviceOptions().rendererOptions());
  renderer_->setTransferFunction(loaded.scene.transferFunction);
  rendererText_ = configuration.rendererText();
  return *renderer_;
}

void ChartMeasurer::draw(const Measurement& measurement, chart::CsvRow& row) {
  const LoadedScene& loaded = loaded_->loaded();
  const ImageSize size = sizeOf(measurement);
  render::Renderer& renderer = rendererFor(measurement.configuration);
  render::RenderOptions options = measurement.configuration.deviceOptions().renderOptions();
  options.timed = true;

  // The picture is also a warm-up of what is timed.
  RunStats run;
  run.frames = {renderer.draw(loaded.scene.camera, size, options)};
  const Image picture = renderer.readImage();
  failOnValidationMessages();
  addCounts(statsJson(loaded, context_.info(), renderer, run), row);
  if (measurement.kind != MeasurementKind::Time) comparePicture(measurement, picture, row);
  if (measurement.kind == MeasurementKind::Error) return;

  const TimedTurn turn{.warmupMs = defaultWarmupMs(context_.info()), .frames = frames_, .limitSeconds = kLimitSeconds};
  run.frames = timeTurn(renderer, loaded.scene.camera, size, options, turn, [] {});
  failOnValidationMessages();
  addTimes(statsJson(loaded, context_.info(), renderer, run), row);
}

void ChartMeasurer::comparePicture(const Measurement& measurement, const Image& picture, chart::CsvRow& row) {
  const Image& exact = loaded_->exactPicture().image;
  addErrors(compareImages(exact, picture), row);
  const std::vector<std::string> files = pictureFiles(measurement);
  if (files.empty()) return;
  writePng(picture, pictures_ / files[0], glm::vec3(loaded_->loaded().scene.background));
  writePng(chart::differencePicture(exact, picture), pictures_ / files[1], glm::vec3(0.0f));
}

}  // namespace tetralux::cli
