// What `chart` measures: scenes times configurations, as one list.
#pragma once

#include <string>
#include <vector>

#include "cli/chart_configuration.h"
#include "view/camera.h"

namespace tetralux::cli {

// A scene to be measured.
struct ChartScene {
  std::string name;                  // unique within a plan; names files
  std::string path;                  // of the scene or mesh; empty: generated
  std::uint64_t generatedCells = 0;  // about so many
};

// What a measurement finds out.
enum class MeasurementKind {
  Picture,   // error and time
  Error,     // error alone
  Time,      // time alone
  Segments,  // what control points cost, whatever the configuration
};
const char* measurementKindName(MeasurementKind kind);

struct Measurement {
  MeasurementKind kind = MeasurementKind::Picture;
  size_t scene = 0;  // index in the plan
  Configuration configuration;
  std::uint32_t side = 0;  // of a square image, pixels; 0: the scene's size
};

struct ChartPlan {
  std::vector<ChartScene> scenes;         // those named first, then generated ones
  std::vector<Measurement> measurements;  // scene by scene, configurations that share a renderer together
};

struct PlanOptions {
  std::vector<std::string> scenes;          // paths
  std::vector<std::string> configurations;  // as Configuration::parse() takes them; empty: the default list
  std::vector<std::string> sets;            // of chartSetNames(); empty: all, or configurations and segments alone
  std::vector<std::uint64_t> cells;         // of generated meshes
};

// Names of the parts of a plan, for --set.
const std::vector<std::string>& chartSetNames();

// The plan. Throws Error(Usage) for a configuration that cannot be read.
ChartPlan makeChartPlan(const PlanOptions& options);

}  // namespace tetralux::cli
