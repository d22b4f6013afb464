// Every command with no, missing, unknown and bad arguments: one line on standard error, exit status 2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/commands.h"
#include "support/run_program.h"
#include "support/temp_dir.h"

namespace tetralux::cli {
namespace {

using test::runTetralux;
using ::testing::HasSubstr;
using ::testing::StartsWith;

void expectUsageError(const std::vector<std::string>& arguments, const std::string& part) {
  const test::TempDir dir;
  const auto result = runTetralux(arguments, dir.path());
  EXPECT_EQ(result.status, 2) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, StartsWith("tetralux: "));
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr(part));
  EXPECT_EQ(dir.entries(), 0u);
}

TEST(Usage, HelpAndVersionArePrinted) {
  const test::TempDir dir;
  const auto help = runTetralux({"--help"}, dir.path());
  EXPECT_EQ(help.status, 0);
  for (const CommandEntry& command : commandTable()) {
    EXPECT_THAT(help.out, HasSubstr(command.name));
    const auto commandHelp = runTetralux({command.name, "--help"}, dir.path());
    EXPECT_EQ(commandHelp.status, 0);
    EXPECT_THAT(commandHelp.out, HasSubstr(command.summary));
  }
  const auto version = runTetralux({"--version"}, dir.path());
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out, std::string("tetralux ") + versionString() + "\n");
}

TEST(Usage, NoOrUnknownCommand) {
  expectUsageError({}, "command: missing, expected one of render, reference, ");
  expectUsageError({"draw"}, "command: found 'draw', expected one of render, reference, ");
}

TEST(Usage, MissingArguments) {
  expectUsageError({"render"}, "input is required");
  expectUsageError({"reference"}, "is required");
  expectUsageError({"reference", "a.json"}, "--output is required");
  expectUsageError({"compare", "a.exr"}, "image is required");
  expectUsageError({"bench"}, "scenes is required");
  expectUsageError({"mesh", "demo"}, "--output is required");
  expectUsageError({"info"}, "input is required");
  expectUsageError({"chart"}, "is required");
  expectUsageError({"chart", "m.vtu"}, "--out is required");
  expectUsageError({"table"}, "is required");
  expectUsageError({"table", "psi"}, "--output is required");
  expectUsageError({"table", "preint2d", "-o", "a.exr"}, "table preint2d: neither --scene nor --tf");
  expectUsageError({"render", "a.json", "-o"}, "--output");
  expectUsageError({"render", "a.json", "--size"}, "--size");
}

TEST(Usage, UnknownOptions) {
  for (const char* command : {"render", "reference", "compare", "bench", "chart", "mesh", "table", "info", "devices"})
    expectUsageError({command, "--no-such-option"}, command == std::string("devices") ? "no-such-option" : "");
}

TEST(Usage, BadValues) {
  expectUsageError({"render", "a.vtu", "--size", "axb"},
                   "--size: found 'axb', expected WxH with sides from 1 to 65536");
  expectUsageError({"render", "a.vtu", "--size", "0x5"}, "--size: found '0x5'");
  expectUsageError({"render", "a.vtu", "--size", "10x10x"}, "--size: found '10x10x'");
  expectUsageError({"render", "a.vtu", "--frames", "0"}, "--frames");
  expectUsageError({"render", "a.vtu", "-o", "a.jpg"}, "-o: found 'a.jpg', expected a name that ends in .exr or .png");
  expectUsageError({"render", "a.vtu", "--frames", "3", "-o", "a.exr"}, "expected a place for the frame's number");
  expectUsageError({"render", "a.vtu", "-o", "%s.exr"}, "-o: found '%s.exr'");
  expectUsageError({"render", "a.vtu", "--target", "rgba64f"}, "--target");
  expectUsageError({"render", "a.vtu", "--projection", "guess"}, "--projection");
  expectUsageError({"info", "a.vtu", "--orders", "--projection", "march"}, "--orders: found '--projection march'");
  expectUsageError({"render", "a.vtu", "--chunk-cells", "0"}, "--chunk-cells");
  expectUsageError({"render", "a.vtu", "--certify", "0"}, "--certify");
  expectUsageError({"render", "a.vtu", "--certify-tolerance", "nan"},
                   "--certify-tolerance: found 'nan', expected a finite number >= 0");
  expectUsageError({"stability", "--out", "d", "--region", "mars"},
                   "--region: found 'mars', expected one of: depth grid");
  for (const char* command : {"render", "reference", "bench"}) {
    for (const char* value : {"0", "-1", "nan", "inf", "1e999", "x", ""})
      expectUsageError({command, "a.json", "--opacity-scale", value},
                       "--opacity-scale: found '" + std::string(value) + "', expected a finite number > 0");
  }
  expectUsageError({"render", "a.vtu", "--exr-compression", "zap"}, "zap");
  expectUsageError({"render", "a.vtu", "--integration", "guess"}, "--integration");
  expectUsageError({"render", "a.vtu", "--interpolation", "none"}, "--interpolation");
  expectUsageError({"render", "a.vtu", "--table-format", "f64"}, "--table-format");
  expectUsageError({"render", "a.vtu", "--table-build", "fast"}, "--table-build");
  expectUsageError({"render", "a.vtu", "--table-size", "1"}, "--table-size: found '1', expected N, NxM or NxMxL");
  const auto expectBadChart = [](const std::vector<std::string>& options, const std::string& part) {
    std::vector<std::string> arguments = {"chart", "m.vtu", "--out", "c"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    expectUsageError(arguments, part);
  };
  expectBadChart({"--configuration", "colour=red"}, "found key 'colour', expected one of integration");
  expectBadChart({"--configuration", "exact"}, "found 'exact', expected KEY=VALUE");
  expectBadChart({"--configuration", "integration=best"}, "--integration: found 'best', expected one of exact");
  expectBadChart({"--configuration", "projection=pt,k=1000"}, "k: found '1000', expected a number from 0 to");
  expectBadChart({"--configuration", "table-size=1"}, "--table-size: found '1'");
  expectBadChart({"--set", "pictures"}, "pictures");
  expectBadChart({"--cells", "10"}, "10");
  expectUsageError({"table", "preint4d", "-o", "a.exr"}, "preint4d");
  expectUsageError({"table", "psi", "-o", "a.png"}, "expected a name that ends in .exr");
  expectUsageError({"reference", "a.json", "-o", "a.png"}, "expected a name that ends in .exr");
  expectUsageError({"mesh", "sphere", "-o", "a.vtu"}, "sphere");
  expectUsageError({"mesh", "box", "-o", "a.obj"}, "expected a name that ends in .vtu");
  expectUsageError({"mesh", "box", "--cells", "0", "-o", "a.vtu"}, "--cells");
  expectUsageError({"mesh", "demo", "--cells", "10", "-o", "a.vtu"}, "expected at least 1000");
  expectUsageError({"compare", "a", "b", "--fail-above", "-1"}, "--fail-above");
  expectUsageError({"bench", "a.json", "--frames", "x"}, "--frames");
}

}  // namespace
}  // namespace tetralux::cli
