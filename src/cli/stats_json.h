// Statistics under their fixed names.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/load_scene.h"
#include "render/renderer.h"

namespace tetralux::cli {

// Everything that happened to the frames of one scene.
struct RunStats {
  std::vector<render::FrameStats> frames;
  double firstFrameMs = 0.0;  // from the program's start to the first frame written (or ready, when none is written)
};

// The object that --stats and bench --json write. Times are medians over the frames, ms; sizes are bytes.
nlohmann::ordered_json statsJson(const LoadedScene& loaded, const gpu::DeviceInfo& device,
                                 const render::Renderer& renderer, const RunStats& run);

// What is known about the order of a frame: the object "order_check". Counts that were not made are null.
nlohmann::ordered_json orderJson(const render::OrderReport& report);

// How a tolerance is kept: its value and the decisions; null without one.
nlohmann::ordered_json toleranceJson(const std::optional<render::TolerancePlan>& plan);

// The passes that a frame may have, by the names of their times.
const std::vector<std::string>& passNames();

// Median of a pass's times, ms; 0 when it was not timed.
double medianPassMs(const std::vector<render::FrameStats>& frames, const std::string& pass);
double medianFrameMs(const std::vector<render::FrameStats>& frames);
double medianReadbackMs(const std::vector<render::FrameStats>& frames);

}  // namespace tetralux::cli
