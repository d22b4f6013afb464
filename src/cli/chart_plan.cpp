#include "cli/chart_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "render/order/cell_order.h"

namespace tetralux::cli {
namespace {

constexpr std::uint32_t kImageSides[] = {50, 100, 200, 400, 512, 800, 1024, 2048};

// Sides of tables: beyond these a table of 8 bytes an entry takes more than 32 MiB, or longer to make than many frames.
constexpr std::uint32_t kSides2d[] = {16, 32, 64, 128, 256, 512, 1024};
constexpr std::uint32_t kSides3d[] = {16, 32, 64, 128, 256};

using Configurations = std::vector<Configuration>;

void addUnlessThere(Configurations& list, const Configuration& configuration) {
  if (std::find(list.begin(), list.end(), configuration) == list.end()) list.push_back(configuration);
}

void addEvery(Configurations& list, const std::string& key, const std::vector<std::string>& values) {
  for (const std::string& value : values) addUnlessThere(list, Configuration().with(key, value));
}

// Those that are drawn, not the choice among them.
std::vector<std::string> projections() {
  std::vector<std::string> names = render::projectionNames();
  std::erase(names, render::projectionName(render::CellProjection::Auto));
  return names;
}

// What a tolerance costs, as the program chooses.
void addTolerances(Configurations& list) {
  for (const char* tolerance : {"1/32", "1/128", "1/510", "1/4096"})
    addUnlessThere(list, Configuration().with("projection", "auto").with("tolerance", tolerance));
}

// Every method by fans and by walking rays, and those that older methods interpolated on the screen.
void addIntegrations(Configurations& list) {
  addEvery(list, "integration", render::integrationNames());
  for (const char* method : {"exact", "average", "preint3d"})
    addUnlessThere(list, Configuration().with("integration", method).with("interpolation", "screen"));
  for (const std::string& method : render::integrationNames())
    addUnlessThere(list, Configuration().with("projection", "march").with("integration", method));
}

Configurations tableSizes() {
  Configurations list;
  for (const std::string& method : render::integrationNames()) {
    const int dimensions = render::tableDimensions(render::parseIntegration(method));
    const Configuration base = Configuration().with("integration", method);
    if (dimensions == 2) {
      for (const std::uint32_t side : kSides2d) list.push_back(base.with("table-size", fmt::format("{0}x{0}", side)));
    } else if (dimensions == 3) {
      // A quarter as many thicknesses as scalars, like the default.
      for (const std::uint32_t side : kSides3d)
        list.push_back(base.with("table-size", fmt::format("{0}x{0}x{1}", side, side / 4)));
    }
  }
  return list;
}

Configurations configurationsOf(const PlanOptions& options, const std::vector<std::string>& sets) {
  Configurations list;
  if (!options.configurations.empty()) {
    for (const std::string& text : options.configurations) addUnlessThere(list, Configuration::parse(text));
    return list;
  }
  for (const std::string& set : sets) {
    if (set == "integrations") addIntegrations(list);
    if (set == "projections") addEvery(list, "projection", projections());
    if (set == "tolerances") addTolerances(list);
    if (set == "targets") addEvery(list, "target", render::targetNames());
    if (set == "orders") addEvery(list, "order", {"auto", "radix", "exact"});
  }
  return list;
}

std::vector<ChartScene> namedScenes(const std::vector<std::string>& paths) {
  std::vector<ChartScene> scenes;
  for (const std::string& path : paths) {
    const std::string stem = std::filesystem::path(path).stem().string();
    std::string name = stem;
    const auto isTaken = [&] {
      return std::any_of(scenes.begin(), scenes.end(), [&](const ChartScene& s) { return s.name == name; });
    };
    for (int i = 2; isTaken(); i++) name = fmt::format("{}-{}", stem, i);
    scenes.push_back({name, path});
  }
  return scenes;
}

}  // namespace

const char* measurementKindName(MeasurementKind kind) {
  static constexpr const char* kNames[] = {"picture", "error", "time", "segments"};
  return kNames[static_cast<size_t>(kind)];
}

const std::vector<std::string>& chartSetNames() {
  static const std::vector<std::string> names = {"integrations", "projections", "targets", "orders",  "tolerances",
                                                 "tables",       "image-sizes", "cells",   "segments"};
  return names;
}

ChartPlan makeChartPlan(const PlanOptions& options) {
  std::vector<std::string> sets = options.sets;
  if (sets.empty()) sets = options.configurations.empty() ? chartSetNames() : std::vector<std::string>{"segments"};
  const auto isAsked = [&](const char* set) { return std::find(sets.begin(), sets.end(), set) != sets.end(); };

  ChartPlan plan;
  plan.scenes = namedScenes(options.scenes);
  Configurations projected;
  addEvery(projected, "projection", projections());
  const Configurations configurations = configurationsOf(options, sets);
  for (size_t scene = 0; scene < plan.scenes.size(); scene++) {
    const size_t first = plan.measurements.size();
    const auto add = [&](MeasurementKind kind, const Configuration& configuration, std::uint32_t side = 0) {
      plan.measurements.push_back({kind, scene, configuration, side});
    };
    if (isAsked("segments")) add(MeasurementKind::Segments, {});
    for (const Configuration& c : configurations) add(MeasurementKind::Picture, c);
    if (isAsked("tables")) {
      for (const Configuration& c : tableSizes()) add(MeasurementKind::Error, c);
    }
    for (const Configuration& c : projected) {
      if (isAsked("cells")) add(MeasurementKind::Time, c);
      if (!isAsked("image-sizes")) continue;
      for (const std::uint32_t side : kImageSides) add(MeasurementKind::Time, c, side);
    }
    // One renderer after the other; within one, everything as above.
    std::stable_sort(plan.measurements.begin() + static_cast<std::ptrdiff_t>(first), plan.measurements.end(),
                     [](const Measurement& a, const Measurement& b) {
                       return a.configuration.rendererText() < b.configuration.rendererText();
                     });
  }
  if (isAsked("cells")) {
    for (const std::uint64_t cells : options.cells) {
      plan.scenes.push_back({fmt::format("generated-{}", cells), "", cells});
      for (const Configuration& c : projected)
        plan.measurements.push_back({MeasurementKind::Time, plan.scenes.size() - 1, c, 0});
    }
  }
  return plan;
}

}  // namespace tetralux::cli
