#include "cli/stats_json.h"

#include <algorithm>
#include <cmath>

#include "base/memory.h"
#include "cli/commands.h"

namespace tetralux::cli {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const size_t middle = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(middle), values.end());
  return values[middle];
}

template <typename Function>
double medianOf(const std::vector<render::FrameStats>& frames, const Function& value) {
  std::vector<double> values;
  for (const render::FrameStats& frame : frames) values.push_back(value(frame));
  return median(std::move(values));
}

// A microsecond is more than clocks here can tell.
double rounded(double milliseconds) { return std::round(milliseconds * 1e3) / 1e3; }

}  // namespace

nlohmann::ordered_json orderJson(const render::OrderReport& report) {
  const auto ifChecked = [&](std::uint64_t count) {
    return report.isChecked ? nlohmann::ordered_json(count) : nlohmann::ordered_json(nullptr);
  };
  nlohmann::ordered_json json;
  json["exact"] = report.isChecked || report.order == render::Order::KBuffer ? nlohmann::ordered_json(report.isExact())
                                                                             : nlohmann::ordered_json(nullptr);
  json["faces"] = ifChecked(report.faces);
  json["misordered"] = ifChecked(report.misordered);
  json["relations"] = ifChecked(report.relations);
  json["misordered_relations"] = ifChecked(report.misorderedRelations);
  json["cyclic_tets"] = report.cyclicCells;
  json["apart_tets"] = report.apartCells;
  json["short_pixels"] = report.shortPixels;
  json["levels"] = report.levels;
  return json;
}

const std::vector<std::string>& passNames() {
  static const std::vector<std::string> names = {"cull",    "order",   "check", "sort",  "project",  "raster", "apart",
                                                 "combine", "measure", "skip",  "enter", "surfaces", "march"};
  return names;
}

double medianPassMs(const std::vector<render::FrameStats>& frames, const std::string& pass) {
  return medianOf(frames, [&](const render::FrameStats& frame) {
    for (const gpu::PassTime& time : frame.passes) {
      if (time.name == pass) return time.gpuMs;
    }
    return 0.0;
  });
}

double medianFrameMs(const std::vector<render::FrameStats>& frames) {
  return medianOf(frames, [](const render::FrameStats& frame) { return frame.frameMs; });
}

double medianReadbackMs(const std::vector<render::FrameStats>& frames) {
  return medianOf(frames, [](const render::FrameStats& frame) { return frame.readbackMs; });
}

nlohmann::ordered_json toleranceJson(const std::optional<render::TolerancePlan>& plan) {
  if (!plan) return nullptr;
  nlohmann::ordered_json decisions = nlohmann::ordered_json::array();
  for (const render::ToleranceDecision& decision : plan->decisions)
    decisions.push_back({{"what", decision.what},
                         {"choice", decision.choice},
                         {"reason", decision.reason},
                         {"figure", decision.figure}});
  return {{"value", plan->tolerance}, {"decisions", decisions}};
}

nlohmann::ordered_json statsJson(const LoadedScene& loaded, const gpu::DeviceInfo& device,
                                 const render::Renderer& renderer, const RunStats& run) {
  const render::FrameStats& last = run.frames.back();
  const render::MemoryUse memory = renderer.memoryUse();
  nlohmann::ordered_json json;
  json["version"] = versionString();
  json["device"] = device.name;
  json["driver"] = device.driver;
  json["mesh"] = loaded.scene.meshPath.string();
  json["field"] = loaded.field.name;
  json["width"] = loaded.scene.size.width;
  json["height"] = loaded.scene.size.height;
  json["integration"] = render::integrationName(last.integration);
  json["table_build"] = last.tableBuild ? nlohmann::ordered_json(render::tableBuildName(*last.tableBuild))
                                        : nlohmann::ordered_json(nullptr);
  json["interpolation"] = render::interpolationName(last.interpolation);
  json["projection"] = render::projectionName(renderer.projection());
  json["double_precision"] = last.doublePrecision;
  json["order"] = render::orderName(last.order.order);
  json["target"] = render::targetName(last.target);
  json["tolerance"] = toleranceJson(last.plan);
  json["frames"] = run.frames.size();
  json["tets"] = renderer.cellCount();
  json["points"] = renderer.pointCount();
  json["drawn_tets"] = last.drawnCells;
  json["clipped_tets"] =
      last.clippedCells ? nlohmann::ordered_json(*last.clippedCells) : nlohmann::ordered_json(nullptr);
  json["triangles"] = last.triangles;
  json["culled"] = {
      {"no_sample", last.culledNoSample}, {"transparent", last.culledTransparent}, {"outside", last.culledOutside}};
  json["order_check"] = orderJson(last.order);
  json["ms"] = {{"load", rounded(loaded.loadMs)},
                {"first_frame", rounded(run.firstFrameMs)},
                {"frame", rounded(medianFrameMs(run.frames))},
                {"tables", rounded(last.tablesMs)}};
  for (const std::string& pass : passNames()) json["ms"][pass] = rounded(medianPassMs(run.frames, pass));
  json["ms"]["readback"] = rounded(medianReadbackMs(run.frames));
  json["bytes"] = {{"mesh", memory.meshBytes},
                   {"frame", memory.frameBytes},
                   {"order", memory.orderBytes},
                   {"tables", memory.tableBytes}};
  json["memory_budget"] = {{"heap", memory.budget.heapBytes},
                           {"available", memory.budget.isReported ? nlohmann::ordered_json(memory.budget.availableBytes)
                                                                  : nlohmann::ordered_json(nullptr)}};
  const auto perTet = [&](std::uint64_t bytes) {
    return std::round(static_cast<double>(bytes) / static_cast<double>(renderer.cellCount()) * 100.0) / 100.0;
  };
  json["bytes_per_tet"] = {
      {"host_mesh", perTet(memory.hostMeshBytes)}, {"host_adjacency", perTet(memory.hostAdjacencyBytes)},
      {"mesh", perTet(memory.meshBytes)},          {"topology", perTet(memory.topologyBytes)},
      {"order", perTet(memory.cellOrderBytes)},    {"lists", perTet(memory.pictureBytes)},
      {"tables", perTet(memory.tableBytes)},       {"process_peak", perTet(peakMemoryBytes())}};
  return json;
}

}  // namespace tetralux::cli
