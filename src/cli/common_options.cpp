#include "cli/common_options.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/progress.h"
#include "gpu/validation.h"
#include "scene/scene_file.h"
#include "scene/transfer_file.h"
#include "shared/limits.h"
#include "shared/pixel_lists.h"

namespace tetralux::cli {
namespace {

// --force-path small-memory: less than any mesh and picture take.
constexpr std::uint64_t kSmallMemoryBytes = 16;

}  // namespace

void SceneOptions::add(CLI::App& app) {
  app.add_option("--size", size, "Image size in pixels, WxH (default: the scene's; 1024x768 for a mesh)");
  app.add_option("--camera", cameraFile, "JSON file with a \"camera\", used instead of the scene's");
  addTransfer(app);
  appearance.add(app);
}

void SceneOptions::addTransfer(CLI::App& app) {
  app.add_option("--field", field, "Point or cell array to draw (default: the scene's; the mesh's first scalar)");
  std::string presets;
  for (const std::string& name : transferPresetNames()) presets += (presets.empty() ? "" : ", ") + name;
  app.add_option("--tf", transfer, "Transfer function: a JSON file, or a preset: " + presets);
  app.add_option("--opacity-scale", opacityScale, "Multiplies every extinction (default: 1)")
      ->type_name("F")
      ->check([](const std::string& text) {
        double value = 0.0;
        const bool isNumber = CLI::detail::lexical_cast(text, value);
        return isNumber && std::isfinite(value) && value > 0.0 ? std::string()
                                                               : "found '" + text + "', expected a finite number > 0";
      });
}

void DeviceOptions::add(CLI::App& app) {
  addDevice(app);
  app.add_option("--target", target, "What cells are blended into (default: rgba32f)")
      ->check(CLI::IsMember(render::targetNames()));
  app.add_option("--chunk-cells", chunkCells,
                 "Cells to a chunk of --target rgba16f-chunked (default: a 32nd of the mesh's; never over 256 chunks)")
      ->check(CLI::Range(1u, shared::BATCH_CELLS));
  app.add_option("--k", kBuffer, "Segments that --order kbuffer holds back at every pixel (default: 6)")
      ->check(CLI::Range(0u, shared::KBUFFER_LARGEST));
  app.add_option("--projection", projection,
                 "How cells become light in pixels (default: auto, which is "
                 "march, or silhouette where --order or --target asks for blending)")
      ->check(CLI::IsMember(render::projectionNames()));
  app.add_option("--order", order, "Order in which cells are drawn (default: auto)")
      ->check(CLI::IsMember(render::orderNames()));
  app.add_option("--integration", integration, "How light is integrated through a cell (default: exact)")
      ->check(CLI::IsMember(render::integrationNames()));
  app.add_option("--interpolation", interpolation,
                 "What is interpolated over a cell's triangles: as perspective has it, or linearly on the screen "
                 "(default: perspective)")
      ->check(CLI::IsMember(render::interpolationNames()));
  app.add_option("--tolerance", tolerance,
                 "Largest error per pixel and channel, such as 0.002 or 1/510: draw as cheaply as is known to keep it "
                 "(default: integrated exactly, up to rounding)")
      ->type_name("E");
  addTable(app);
  app.add_option("--force-path", forcePath, "For tests: take a code path that this device would not choose")
      ->check(CLI::IsMember({"wide-addressing", "sort-tiles", "sort-chunks", "table-fetch", "snap-vertices",
                             "walk-single", "walk-double", "skip-empty", "no-skip", "gpu-rays", "small-memory"}));
}

void DeviceOptions::addDevice(CLI::App& app) {
  app.add_option("--device", device, "Vulkan device: index or part of its name (default: the best one)");
  app.add_flag("--validate", validate, "Run with Vulkan's validation layers; any message is an error");
}

void DeviceOptions::addTable(CLI::App& app) {
  app.add_option("--table-size", tableSize,
                 "Entries of the method's table, N, NxM or NxMxL (default: ppi 512, opacity2d and preint2d 256, "
                 "preint3d 128x128x32)");
  app.add_option("--table-format", tableFormat, "How a table's entries are stored (default: unorm16)")
      ->check(CLI::IsMember(render::tableFormatNames()));
  app.add_option("--table-build", tableBuild,
                 "How tables of three dimensions are made: every entry exactly, or slice by slice (default: exact)")
      ->check(CLI::IsMember(render::tableBuildNames()));
}

render::TableOptions DeviceOptions::tableOptions() const {
  render::TableOptions table;
  if (!tableSize.empty()) table.size = render::parseTableSize(tableSize);
  if (!tableFormat.empty()) table.format = render::parseTableFormat(tableFormat);
  table.build = render::parseTableBuild(tableBuild);
  table.forceFetch = forcePath == "table-fetch";
  return table;
}

render::RenderOptions DeviceOptions::renderOptions() const {
  render::RenderOptions options;
  options.target = render::parseTarget(target);
  options.chunkCells = chunkCells;
  options.integration = render::parseIntegration(integration);
  options.interpolation = render::parseInterpolation(interpolation);
  options.table = tableOptions();
  return options;
}

std::optional<double> DeviceOptions::toleranceValue() const {
  return tolerance.empty() ? std::nullopt : std::optional(parseTolerance(tolerance));
}

gpu::ContextOptions DeviceOptions::contextOptions() const {
  gpu::ContextOptions options{device, validate};
  if (forcePath == "small-memory") options.availableBytes = kSmallMemoryBytes;
  return options;
}

render::RendererOptions DeviceOptions::rendererOptions() const {
  render::RendererOptions options;
  options.projection = render::parseProjection(projection);
  options.order = render::parseOrder(order);
  options.tolerance = toleranceValue();
  // What only cells that are drawn have.
  const std::string_view blended[] = {"rgba8", "rgba8-dither", "rgba16f", "rgba16f-chunked"};
  const bool isBlended = std::find(std::begin(blended), std::end(blended), target) != std::end(blended);
  options.mayWalk = !isBlended;
  if (options.projection == render::CellProjection::Auto && interpolation == "screen")
    options.projection = render::CellProjection::Pt;
  options.kBuffer = kBuffer;
  options.forceWideAddressing = forcePath == "wide-addressing";
  if (forcePath == "walk-single" || forcePath == "walk-double") options.doublePrecision = forcePath == "walk-double";
  if (forcePath == "skip-empty" || forcePath == "no-skip") options.skipEmptySpace = forcePath == "skip-empty";
  if (forcePath == "gpu-rays") options.gpuRays = true;
  if (forcePath == "snap-vertices") options.snapVertices = true;
  if (forcePath == "sort-tiles") options.sortVariant = render::SortVariant::Tiles;
  if (forcePath == "sort-chunks") options.sortVariant = render::SortVariant::Chunks;
  return options;
}

void addQuiet(CLI::App& app) {
  app.add_flag_callback(
      "--quiet",
      [] {
        setProgressEnabled(false);
        spdlog::set_level(spdlog::level::err);
      },
      "No progress and no remarks, errors only");
}

double parseTolerance(const std::string& text) {
  const auto number = [&](size_t begin, size_t end) {
    double value = 0.0;
    const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, value);
    return error == std::errc() && stop == text.data() + end ? value : 0.0;
  };
  const size_t slash = text.find('/');
  const double value =
      slash == std::string::npos ? number(0, text.size()) : number(0, slash) / number(slash + 1, text.size());
  if (!(value > 0.0 && value <= 1.0))
    fail(ErrorCode::Usage, "--tolerance: found '{}', expected a number above 0 and at most 1, such as 0.002 or 1/510",
         text);
  return value;
}

ImageSize parseSize(const std::string& text) {
  ImageSize size;
  const size_t cross = text.find('x');
  const auto parse = [&](size_t begin, size_t end, std::uint32_t& value) {
    const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, value);
    return error == std::errc() && stop == text.data() + end && value >= 1 && value <= kLargestImageSide;
  };
  if (cross == std::string::npos || !parse(0, cross, size.width) || !parse(cross + 1, text.size(), size.height))
    fail(ErrorCode::Usage, "--size: found '{}', expected WxH with sides from 1 to {}", text, kLargestImageSide);
  return size;
}

void failOnValidationMessages() {
  const auto messages = gpu::takeValidationMessages();
  if (!messages.empty())
    fail(ErrorCode::Device, "{} validation messages, the first: {}", messages.size(), messages.front());
}

}  // namespace tetralux::cli
