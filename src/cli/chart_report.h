// Charts and the report, from rows and kept pictures: nothing is drawn here.
#pragma once

#include <filesystem>
#include <optional>

#include "cli/chart_plots.h"
#include "image/image.h"

namespace tetralux::cli {

// What the report says of a scene beside its rows.
struct ReportScene {
  std::optional<Image> exact;  // the exact picture over the background, for eyes; nothing without pictures
  ImageSize size;
};

struct ChartReport {
  const ChartPlan& plan;
  std::vector<MeasuredRow> rows;    // of the plan's measurements
  std::vector<ReportScene> scenes;  // of the plan
  std::string device;
  std::string driver;
  std::string version;
  std::string commandLine;
  std::uint32_t thumbnailSide = 0;  // longest side of a picture in the report, pixels
};

// Writes folder/*.svg and folder/report.html. Throws Error(Output), and Error(Input) for a kept picture that cannot be
// read.
//   pictures   folder of the pictures that rows name in `key` (ChartMeasurer::pictureFiles)
void writeChartReport(const ChartReport& report, const std::filesystem::path& folder,
                      const std::filesystem::path& pictures);

}  // namespace tetralux::cli
