#include "cli/floor_report.h"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace

nlohmann::ordered_json floorJson(const gpu::Context& context, render::Renderer& renderer, const Camera& camera,
                                 ImageSize size, const render::RenderOptions& options, std::uint64_t cells,
                                 std::uint64_t points, const std::vector<render::FrameStats>& frames) {
  const double emptyMs = render::emptySubmitMs(context);
  // Where every pass is a submission of its own, its time holds one.
  const double leastMs = gpu::bestTiming(context.info()) == gpu::PassTiming::Submits ? emptyMs : 0.0;
  render::RenderOptions constant = options;
  constant.constantColor = true;
  const std::vector<render::FrameStats> drawn =
      timeTurn(renderer, camera, size, constant, {.warmup = 1, .frames = kFrames}, [] {});
  nlohmann::ordered_json passes = nlohmann::ordered_json::array();
  for (const render::PassWork& work : render::passWork(frames.back(), cells, points, size)) {
    const double ms = medianPassMs(frames, work.pass);
    nlohmann::ordered_json pass = {{"pass", work.pass}, {"ms", ms},           {"bytes", nullptr},   {"items", nullptr},
                                   {"unit", work.unit}, {"copy_ms", nullptr}, {"draw_ms", nullptr}, {"ratio", nullptr}};
    double floorMs = leastMs;
    const auto addFloor = [&](const char* name, double floor) {
      pass[name] = floor;
      floorMs = std::max(floorMs, floor);
    };
    if (work.bytes) pass["bytes"] = *work.bytes;
    if (work.items) pass["items"] = *work.items;
    if (work.bytes) addFloor("copy_ms", render::copyMs(context, *work.bytes));
    if (work.pass == "raster") addFloor("draw_ms", medianPassMs(drawn, work.pass));
    if (work.bytes && floorMs > 0.0) pass["ratio"] = ms / floorMs;
    passes.push_back(std::move(pass));
  }
  return {{"empty_submit_ms", emptyMs}, {"passes", passes}};
}

void printFloor(const nlohmann::ordered_json& floor) {
  fmt::print("  {:<10} {:>9} {:>9} {:>10} {:<10} {:>9} {:>9} {:>7}\n", "pass", "ms", "MB", "items", "", "copy ms",
             "draw ms", "ratio");
  for (const nlohmann::ordered_json& pass : floor["passes"]) {
    const nlohmann::ordered_json megabytes = pass["bytes"].is_null()
                                                 ? nlohmann::ordered_json(nullptr)
                                                 : nlohmann::ordered_json(pass["bytes"].get<double>() * 1e-6);
    fmt::print("  {:<10} {:>9.3f} {:>9} {:>10} {:<10} {:>9} {:>9} {:>7}\n", pass["pass"].get<std::string>(),
               pass["ms"].get<double>(), shown(megabytes, "{:.2f}"), shown(pass["items"], "{:.0f}"),
               pass["unit"].get<std::string>(), shown(pass["copy_ms"], "{:.3f}"), shown(pass["draw_ms"], "{:.3f}"),
               shown(pass["ratio"], "{:.2f}"));
  }
  fmt::print("  empty submission {:.3f} ms\n", floor["empty_submit_ms"].get<double>());
}

}  // namespace tetralux::cli
