// The chart command as a user runs it, on a small mesh.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "chart/csv.h"
#include "image/image_io.h"
#include "support/run_program.h"
#include "support/temp_dir.h"

namespace tetralux::cli {
namespace {

using test::runTetralux;
using ::testing::HasSubstr;
using ::testing::Not;

class Chart : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(runTetralux({"mesh", "random", "--cells", "1500", "-o", "m.vtu", "--quiet"}, dir_.path()).status, 0);
  }

  // Two configurations that differ in error, and one that the renderer refuses.
  test::ProgramResult chart(const std::string& out, const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments = {"chart", "m.vtu", "--out", out, "--size", "32x32", "--frames", "2"};
    for (const char* configuration :
         {"integration=exact", "integration=ppi,table-size=16", "projection=silhouette,interpolation=screen"})
      arguments.insert(arguments.end(), {"--configuration", configuration});
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto result = runTetralux(arguments, dir_.path());
    EXPECT_EQ(result.status, 0) << result.err;
    return result;
  }

  chart::CsvTable rows(const std::string& out) const {
    const auto path = dir_ / (out + "/measurements.csv");
    return chart::parseCsv(readTextFile(path), path.string());
  }

  test::TempDir dir_;
};

TEST_F(Chart, WritesMeasurementsChartsPicturesAndOneReport) {
  chart("c", {"--validate", "--set", "segments", "--set", "tables"});
  const chart::CsvTable table = rows("c");
  std::map<std::string, chart::CsvRow> byName;
  for (const chart::CsvRow& row : table.rows) {
    if (row.at("kind") == "picture") byName[row.at("configuration")] = row;
  }
  ASSERT_EQ(byName.size(), 3u);
  const chart::CsvRow& exact = byName.at("default");
  const chart::CsvRow& ppi = byName.at("ppi 16");
  EXPECT_LT(std::stod(exact.at("rmse")), 5e-5);
  EXPECT_GT(std::stod(ppi.at("rmse")), std::stod(exact.at("rmse")));
  for (const char* column : {"max", "p99", "flip", "ms_frame", "ms_raster", "fps", "tets_per_s", "bytes_mesh"})
    EXPECT_GT(std::stod(exact.at(column)), 0.0) << column;
  EXPECT_EQ(exact.at("frames"), "2");
  EXPECT_EQ(exact.at("note"), "");

  // Refused by the renderer: the reason is in the row, and the run goes on.
  const chart::CsvRow& refused = byName.at("screen silhouette");
  EXPECT_THAT(refused.at("note"), HasSubstr("--interpolation"));
  EXPECT_EQ(refused.at("rmse"), "");

  for (const char* suffix : {".png", "-difference.png"})
    EXPECT_EQ(readPng(dir_ / ("c/pictures/m-" + ppi.at("key") + suffix)).width, 32u);
  for (const char* file : {"m-error-time.svg", "m-table-size.svg", "segments.svg"})
    EXPECT_TRUE(std::filesystem::exists(dir_ / "c" / file)) << file;
  const std::string report = readTextFile(dir_ / "c/report.html");
  EXPECT_THAT(report, HasSubstr("tetralux chart m.vtu --out c --configuration integration=exact"));
  EXPECT_THAT(report, HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(report, HasSubstr("ppi 16"));
  EXPECT_THAT(report, Not(HasSubstr("src=\"http")));
  EXPECT_THAT(report, Not(HasSubstr(dir_.path().string())));
}

TEST_F(Chart, CountsWhatControlPointsCost) {
  chart("c");
  for (const chart::CsvRow& row : rows("c").rows) {
    if (row.at("kind") != "segments") continue;
    EXPECT_GT(std::stod(row.at("cell_pieces")), std::stod(row.at("cells")));
    EXPECT_GT(std::stod(row.at("pieces")), std::stod(row.at("segments")));
    EXPECT_GT(std::stod(row.at("segments")), 1024.0);
    return;
  }
  FAIL() << "no row of segments";
}

TEST_F(Chart, SecondRunMeasuresNothingAgain) {
  chart("c");
  const auto first = rows("c").rows;
  EXPECT_THAT(chart("c").err, HasSubstr("3 of 4 measurements were there"));  // the refused one is tried again
  EXPECT_THAT(rows("c").rows, ::testing::UnorderedElementsAreArray(first));
  EXPECT_THAT(chart("c", {"--fresh"}).err, Not(HasSubstr("were there")));
  EXPECT_THAT(chart("c", {"--opacity-scale", "2"}).err, Not(HasSubstr("were there")));
}

TEST_F(Chart, AnInterruptedRunGoesOnWhereItWas) {
  chart("c");
  const std::string whole = readTextFile(dir_ / "c/measurements.csv");
  // Half of the last line, as a killed run leaves it.
  const size_t lastLine = whole.rfind('\n', whole.size() - 2) + 1;
  dir_.write("c/measurements.csv", whole.substr(0, (lastLine + whole.size()) / 2));
  chart("c");
  EXPECT_EQ(rows("c").rows.size(), 4u);
}

TEST_F(Chart, TwoRunsAgreeInEveryErrorToTheLastDigit) {
  chart("a", {"--set", "tables", "--set", "segments"});
  chart("b", {"--set", "tables", "--set", "segments"});
  const auto a = rows("a").rows;
  const auto b = rows("b").rows;
  ASSERT_EQ(a.size(), b.size());
  size_t compared = 0;
  for (size_t i = 0; i < a.size(); i++) {
    for (const char* column : {"key", "rmse", "max", "p99", "mean", "flip", "non_finite", "segments", "pieces"})
      EXPECT_EQ(a[i].at(column), b[i].at(column)) << a[i].at("configuration") << " " << column;
    compared += !a[i].at("rmse").empty();
  }
  EXPECT_GE(compared, 30u);
}

TEST_F(Chart, SpeedIsChartedAgainstImageSizeAndCells) {
  chart("c", {"--set", "cells", "--cells", "1000,2000"});
  for (const char* file : {"cells-tets-per-second.svg", "cells-frame-rate.svg"})
    EXPECT_THAT(readTextFile(dir_ / "c" / file), HasSubstr(">march<")) << file;
  size_t generated = 0;
  for (const chart::CsvRow& row : rows("c").rows) generated += row.at("scene") == "generated-2000";
  EXPECT_GE(generated, 3u);
}

TEST_F(Chart, AFolderThatCannotBeMadeIsAnOutputError) {
  dir_.write("file", "x");
  const auto result = runTetralux({"chart", "m.vtu", "--out", "file/c", "--quiet"}, dir_.path());
  EXPECT_EQ(result.status, 5);
  EXPECT_THAT(result.err, HasSubstr("file/c"));
}

TEST_F(Chart, ASceneThatIsMissingIsAnInputError) {
  EXPECT_EQ(runTetralux({"chart", "none.json", "--out", "c", "--quiet"}, dir_.path()).status, 3);
}

}  // namespace
}  // namespace tetralux::cli
