// One measurement of a chart: from a scene and a configuration to a row of numbers.
#pragma once

#include <memory>

#include "chart/csv.h"
#include "cli/chart_scene.h"
#include "gpu/context.h"
#include "render/renderer.h"

namespace tetralux::cli {

// Columns of measurements.csv, in order. docs/charts.md tells what each holds.
const std::vector<std::string>& measurementColumns();

class ChartMeasurer {
 public:
  //   context    must outlive the measurer
  //   pictures   folder for pictures, difference pictures and exact pictures; must exist
  //   frames     timed per measurement, >= 1
  ChartMeasurer(const gpu::Context& context, std::filesystem::path pictures, std::uint32_t frames);

  // Turns to a scene. It must outlive the measurements that follow.
  void setScene(const ChartScene& scene, LoadedChartScene& loaded);

  // A name for everything that decides what a measurement finds: scene, configuration, size, frames, device, driver,
  // version. Of the scene set last.
  std::string key(const Measurement& measurement) const;

  // Names of the files in the pictures' folder that a measurement writes; empty for one that writes none.
  std::vector<std::string> pictureFiles(const Measurement& measurement) const;

  // Takes the measurement. A configuration that the renderer refuses gives a row with the reason in `note`. Throws
  // Error(Device), Error(Output).
  chart::CsvRow measure(const Measurement& measurement);

 private:
  ImageSize sizeOf(const Measurement& measurement) const;
  chart::CsvRow identity(const Measurement& measurement) const;
  void measureSegments(chart::CsvRow& row);
  void draw(const Measurement& measurement, chart::CsvRow& row);
  render::Renderer& rendererFor(const Configuration& configuration);
  void comparePicture(const Measurement& measurement, const Image& picture, chart::CsvRow& row);

  const gpu::Context& context_;
  std::filesystem::path pictures_;
  std::uint32_t frames_;
  const ChartScene* scene_ = nullptr;
  LoadedChartScene* loaded_ = nullptr;
  std::unique_ptr<render::Renderer> renderer_;
  std::string rendererText_;  // what renderer_ was made with
};

}  // namespace tetralux::cli
