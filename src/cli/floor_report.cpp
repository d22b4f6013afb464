#include "cli/floor_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "cli/stats_json.h"
#include "cli/timed_frames.h"
#include "render/floor_times.h"
#include "render/pass_work.h"

namespace tetralux::cli {
namespace {

constexpr std::uint32_t kFrames = 5;

std::string shown(const nlohmann::ordered_json& value, const char* format) {
  return value.is_null() ? "-" : fmt::format(fmt::runtime(format), value.get<double>());
}

// The same triangles in one colour.
std::vector<render::FrameStats> constantFrames(render::Renderer& renderer, const Camera& camera, ImageSize size,
                                               render::RenderOptions options) {
  options.constantColor = true;
  return timeTurn(renderer, camera, size, options, {.warmup = 1, .frames = kFrames}, [] {});
}

// All that a frame does when no ray meets the mesh: lists are emptied, faces looked at, the picture is written.
std::vector<render::FrameStats> emptyFrames(render::Renderer& renderer, const Camera& camera, ImageSize size,
                                            const render::RenderOptions& options) {
  const Camera beside = render::besideMesh(camera, size, renderer.space());
  std::vector<render::FrameStats> frames;
  for (std::uint32_t i = 0; i <= kFrames; i++) frames.push_back(renderer.draw(beside, size, options));
  frames.erase(frames.begin());  // touched what the others use
  return frames;
}

// What rays have to do in a frame that is drawn for that alone.
std::optional<render::MarchWork> countedWork(render::Renderer& renderer, const Camera& camera, ImageSize size,
                                             render::RenderOptions options) {
  options.countWork = true;
  options.timed = false;
  return renderer.draw(camera, size, options).march;
}

nlohmann::ordered_json counts(const render::PassWork& work) {
  if (work.counts.empty()) return nullptr;
  nlohmann::ordered_json json;
  for (const auto& [name, count] : work.counts) json[name] = count;
  return json;
}

}  // namespace

nlohmann::ordered_json floorJson(const gpu::Context& context, render::Renderer& renderer, const Camera& camera,
                                 ImageSize size, const render::RenderOptions& options, std::uint64_t cells,
                                 std::uint64_t points, const std::vector<render::FrameStats>& frames) {
  const double emptyMs = render::emptySubmitMs(context);
  // Where every pass is a submission of its own, its time holds one.
  const double leastMs = gpu::bestTiming(context.info()) == gpu::PassTiming::Submits ? emptyMs : 0.0;
  const bool isMarch = renderer.projection() == render::CellProjection::March;
  const std::vector<render::FrameStats> least =
      isMarch ? emptyFrames(renderer, camera, size, options) : constantFrames(renderer, camera, size, options);
  render::FrameStats counted = frames.back();
  if (isMarch)
    counted.march = countedWork(renderer, camera.turned(static_cast<double>(frames.size() - 1)), size, options);
  nlohmann::ordered_json passes = nlohmann::ordered_json::array();
  for (const render::PassWork& work : render::passWork(counted, cells, points, size)) {
    const double ms = medianPassMs(frames, work.pass);
    nlohmann::ordered_json pass = {{"pass", work.pass},  {"ms", ms},           {"bytes", nullptr},
                                   {"items", nullptr},   {"unit", work.unit},  {"counts", counts(work)},
                                   {"copy_ms", nullptr}, {"draw_ms", nullptr}, {"empty_ms", nullptr},
                                   {"ratio", nullptr}};
    double floorMs = leastMs;
    const auto addFloor = [&](const char* name, double floor) {
      pass[name] = floor;
      floorMs = std::max(floorMs, floor);
    };
    if (work.bytes) pass["bytes"] = *work.bytes;
    if (work.items) pass["items"] = *work.items;
    if (work.bytes) addFloor("copy_ms", render::copyMs(context, *work.bytes));
    if (work.pass == "raster") addFloor("draw_ms", medianPassMs(least, work.pass));
    if (isMarch) addFloor("empty_ms", medianPassMs(least, work.pass));
    if (work.bytes && floorMs > 0.0) pass["ratio"] = ms / floorMs;
    passes.push_back(std::move(pass));
  }
  return {{"empty_submit_ms", emptyMs}, {"passes", passes}};
}

void printFloor(const nlohmann::ordered_json& floor) {
  fmt::print("  {:<10} {:>9} {:>9} {:>10} {:<10} {:>9} {:>9} {:>9} {:>7}\n", "pass", "ms", "MB", "items", "", "copy ms",
             "draw ms", "empty ms", "ratio");
  for (const nlohmann::ordered_json& pass : floor["passes"]) {
    const nlohmann::ordered_json megabytes = pass["bytes"].is_null()
                                                 ? nlohmann::ordered_json(nullptr)
                                                 : nlohmann::ordered_json(pass["bytes"].get<double>() * 1e-6);
    fmt::print("  {:<10} {:>9.3f} {:>9} {:>10} {:<10} {:>9} {:>9} {:>9} {:>7}", pass["pass"].get<std::string>(),
               pass["ms"].get<double>(), shown(megabytes, "{:.2f}"), shown(pass["items"], "{:.0f}"),
               pass["unit"].get<std::string>(), shown(pass["copy_ms"], "{:.3f}"), shown(pass["draw_ms"], "{:.3f}"),
               shown(pass["empty_ms"], "{:.3f}"), shown(pass["ratio"], "{:.2f}"));
    for (const auto& [name, count] : pass["counts"].items()) fmt::print("  {} {}", count.get<std::uint64_t>(), name);
    fmt::print("\n");
  }
  fmt::print("  empty submission {:.3f} ms\n", floor["empty_submit_ms"].get<double>());
}

}  // namespace tetralux::cli
