// Each command as a user runs it, on a small mesh.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "image/image_io.h"
#include "image/metrics.h"
#include "support/run_program.h"
#include "support/temp_dir.h"

namespace tetralux::cli {
namespace {

using nlohmann::json;
using test::runTetralux;
using ::testing::HasSubstr;

class Commands : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(run({"mesh", "random", "--cells", "3000", "-o", "m.vtu", "--quiet"}).status, 0); }

  test::ProgramResult run(const std::vector<std::string>& arguments) {
    auto result = runTetralux(arguments, dir_.path());
    EXPECT_EQ(result.status, 0) << result.err;
    return result;
  }

  test::TempDir dir_;
};

TEST_F(Commands, RenderOfABareMeshMakesAPictureBesideIt) {
  const auto result = run({"render", "m.vtu", "--size", "64x48"});
  EXPECT_THAT(result.err, HasSubstr("wrote m.png"));
  const Image image = readPng(dir_ / "m.png");
  EXPECT_EQ(image.width, 64u);
  float brightest = 0.0f;
  for (const glm::vec4& p : image.pixels) brightest = std::max({brightest, p.x, p.y, p.z});
  EXPECT_GT(brightest, 0.2f);
}

TEST_F(Commands, RenderAgreesWithReference) {
  run({"render", "m.vtu", "--size", "64x48", "-o", "a.exr", "--quiet", "--validate"});
  run({"reference", "m.vtu", "--size", "64x48", "-o", "b.exr", "--quiet"});
  EXPECT_LE(compareImages(readExr(dir_ / "b.exr"), readExr(dir_ / "a.exr")).rmse, 5e-5);
  EXPECT_EQ(readExrAttribute(dir_ / "a.exr", "tetralux.field"), "scalar");
  EXPECT_EQ(readExrAttribute(dir_ / "b.exr", "tetralux.method"), "reference");
}

TEST_F(Commands, InfoTellsWhatEveryOrderGetsWrong) {
  const json info =
      json::parse(run({"info", "m.vtu", "--orders", "--size", "48x48", "--frames", "1", "--json", "--quiet"}).out);
  ASSERT_EQ(info["orders"].size(), 8u);
  for (const json& order : info["orders"]) {
    const std::string name = order["order"];
    EXPECT_GT(order["faces"].get<int>(), 100) << name;
    EXPECT_GT(order["frame_ms"].get<double>(), 0.0) << name;
    if (name == "auto" || name == "exact") {
      EXPECT_TRUE(order["exact"].get<bool>()) << name;
    }
    if (name == "none" || name == "bucket") {
      EXPECT_GT(order["misordered"].get<int>(), 0) << name;
    }
  }
}

TEST_F(Commands, StatisticsNameTheOrderThatWasDrawn) {
  run({"render", "m.vtu", "--size", "48x48", "-o", "a.exr", "--quiet", "--stats", "s.json", "--order", "radix"});
  const json stats = json::parse(readFile(dir_ / "s.json"));
  EXPECT_EQ(stats["order"], "radix");
  EXPECT_FALSE(stats["order_check"]["exact"].get<bool>());
  EXPECT_GT(stats["order_check"]["misordered"].get<int>(), 0);
  EXPECT_EQ(readExrAttribute(dir_ / "a.exr", "tetralux.order"), "radix");
}

TEST_F(Commands, ScatteredMeshesAreOrderedAndDrawnTheSame) {
  for (const bool isShuffled : {false, true}) {
    std::vector<std::string> arguments = {"mesh", "box", "--cells", "120000", "-o", "large.vtu", "--quiet"};
    if (isShuffled) arguments.push_back("--shuffle");
    run(arguments);
    const auto result = run({"render", "large.vtu", "--size", "64x64", "-o", isShuffled ? "b.exr" : "a.exr"});
    EXPECT_EQ(result.err.find("points and cells are scattered over the file") != std::string::npos, isShuffled)
        << result.err;
  }
  EXPECT_LE(compareImages(readExr(dir_ / "a.exr"), readExr(dir_ / "b.exr")).max, 2e-5);
}

TEST_F(Commands, QuietIsQuiet) {
  const auto result = run({"render", "m.vtu", "--size", "16x16", "--quiet"});
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "");
}

TEST_F(Commands, FramesMakeAFullTurn) {
  run({"render", "m.vtu", "--size", "32x32", "--frames", "4", "-o", "f_%02d.exr", "--quiet", "--stats", "s.json"});
  for (const char* name : {"f_00.exr", "f_01.exr", "f_02.exr", "f_03.exr"})
    EXPECT_TRUE(std::filesystem::exists(dir_ / name));
  EXPECT_FALSE(std::filesystem::exists(dir_ / "f_04.exr"));
  EXPECT_GT(compareImages(readExr(dir_ / "f_00.exr"), readExr(dir_ / "f_01.exr")).rmse, 1e-3);
  EXPECT_EQ(json::parse(readTextFile(dir_ / "s.json"))["frames"], 4);
}

TEST_F(Commands, StatisticsHaveTheirFixedKeys) {
  run({"render", "m.vtu", "--size", "32x32", "-o", "a.exr", "--projection", "pt", "--quiet", "--stats", "s.json"});
  const json stats = json::parse(readTextFile(dir_ / "s.json"));
  for (const char* key :
       {"device", "driver", "width", "height", "integration", "interpolation", "projection", "order", "target", "tets",
        "points", "drawn_tets", "triangles", "culled", "order_check", "ms", "bytes", "bytes_per_tet", "memory_budget"})
    EXPECT_TRUE(stats.contains(key)) << key;
  for (const char* key : {"no_sample", "transparent", "outside"}) EXPECT_TRUE(stats["culled"].contains(key)) << key;
  for (const char* key : {"load", "first_frame", "frame", "project", "sort", "raster", "readback"})
    EXPECT_GE(stats["ms"][key].get<double>(), 0.0) << key;
  for (const char* key : {"mesh", "frame", "tables"}) EXPECT_GT(stats["bytes"][key].get<double>(), 0.0) << key;
  for (const char* key :
       {"host_mesh", "host_adjacency", "mesh", "topology", "order", "lists", "tables", "process_peak"})
    EXPECT_GT(stats["bytes_per_tet"][key].get<double>(), 0.0) << key;
  EXPECT_GT(stats["memory_budget"]["heap"].get<double>(), 0.0);
  EXPECT_TRUE(stats["memory_budget"].contains("available"));  // null where the driver does not tell
  EXPECT_EQ(stats["width"], 32);
  EXPECT_GT(stats["drawn_tets"].get<int>(), 0);
}

TEST_F(Commands, RenderIntegratesByTheMethodAskedFor) {
  run({"render", "m.vtu", "--size", "32x32", "-o", "exact.exr", "--quiet"});
  for (const char* method : {"vertex", "ppi", "preint3d-log"}) {
    run({"render", "m.vtu",        "--size",  "32x32",          "--integration", method,          "--interpolation",
         "screen", "--table-size", "16x16x4", "--table-format", "unorm8",        "--table-build", "incremental",
         "-o",     "a.exr",        "--stats", "s.json",         "--validate",    "--quiet"});
    const json stats = json::parse(readTextFile(dir_ / "s.json"));
    EXPECT_EQ(stats["integration"], method);
    EXPECT_EQ(stats["interpolation"], "screen");
    EXPECT_EQ(stats["table_build"], std::string(method) == "preint3d-log" ? json("incremental") : json(nullptr));
    EXPECT_EQ(stats["ms"]["tables"].get<double>() > 0.0, std::string(method) != "vertex");
    EXPECT_EQ(readExrAttribute(dir_ / "a.exr", "tetralux.integration"), method);
    const double rmse = compareImages(readExr(dir_ / "exact.exr"), readExr(dir_ / "a.exr")).rmse;
    EXPECT_GT(rmse, 1e-5) << method;
    EXPECT_LT(rmse, 0.1) << method;
  }
}

TEST_F(Commands, TableWritesEveryTable) {
  run({"table", "psi", "-o", "psi.exr", "--quiet"});
  const Image psi = readExr(dir_ / "psi.exr");
  EXPECT_EQ(psi.width, 512u);
  EXPECT_EQ(psi.height, 512u);
  EXPECT_NEAR(psi.at(0, 0).x, 1.0f, 1e-5f);
  EXPECT_EQ(psi.at(511, 511).x, 0.0f);
  for (const char* kind : {"opacity2d", "preint2d"}) {
    run({"table", kind, "--scene", "m.vtu", "--table-size", "16", "-o", "t.exr", "--quiet"});
    EXPECT_EQ(readExr(dir_ / "t.exr").width, 16u) << kind;
  }
  for (const char* kind : {"preint3d", "preint3d-log"}) {
    run({"table", kind, "--tf", "heat", "--length", "2", "--table-size", "16x8x5", "-o", "t.exr", "--quiet"});
    const Image table = readExr(dir_ / "t.exr");
    EXPECT_EQ(table.width, 16u * 5u) << kind;  // slices side by side, the first for no thickness
    EXPECT_EQ(table.height, 8u) << kind;
    EXPECT_EQ(table.at(8, 4).w, 0.0f) << kind;
    EXPECT_GT(table.at(16 * 4 + 8, 4).w, table.at(16 * 3 + 8, 4).w) << kind;
  }
}

TEST_F(Commands, CompareJudgesByItsLimits) {
  run({"render", "m.vtu", "--size", "32x32", "-o", "a.exr", "--quiet"});
  run({"render", "m.vtu", "--size", "32x32", "-o", "b.exr", "--tf", "heat", "--quiet"});
  EXPECT_THAT(run({"compare", "a.exr", "a.exr"}).out, HasSubstr("rmse"));
  const json equal = json::parse(run({"compare", "a.exr", "a.exr", "--json", "--fail-above", "0"}).out);
  EXPECT_EQ(equal["rmse"], 0.0);
  EXPECT_TRUE(equal["psnr"].is_null());
  for (const char* key : {"rmse", "max", "p99", "mean", "over_half_level", "psnr", "flip"})
    EXPECT_TRUE(equal.contains(key));
  EXPECT_EQ(runTetralux({"compare", "a.exr", "b.exr", "--fail-above", "1e-3"}, dir_.path()).status, 1);
  EXPECT_EQ(runTetralux({"compare", "a.exr", "b.exr", "--fail-max-above", "1e-3"}, dir_.path()).status, 1);
  EXPECT_EQ(runTetralux({"compare", "a.exr", "b.exr"}, dir_.path()).status, 0);
}

TEST_F(Commands, BenchPrintsAnArrayWithAnObjectPerScene) {
  const json all = json::parse(run({"bench", "m.vtu", "m.vtu", "--size", "32x32", "--frames", "2", "--warmup", "1",
                                    "--warmup-ms", "1", "--max-rmse", "0.05", "--json", "--quiet"})
                                   .out);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0]["frames"], 2);
  EXPECT_GT(all[0]["ms"]["frame"].get<double>(), 0.0);
  EXPECT_GT(all[0]["check"]["pixels"].get<int>(), 500);
  EXPECT_GT(all[0]["transfer_ms"].get<double>(), 0.0);
}

TEST_F(Commands, BenchMeasuresFloors) {
  const json all = json::parse(run({"bench", "m.vtu", "--size", "32x32", "--frames", "1", "--projection", "pt",
                                    "--order", "radix", "--max-rmse", "1", "--floor", "--json", "--quiet"})
                                   .out);
  const json& floor = all[0]["floor"];
  EXPECT_GT(floor["empty_submit_ms"].get<double>(), 0.0);
  std::vector<std::string> measured;
  for (const json& pass : floor["passes"]) {
    if (pass["bytes"].is_null()) continue;
    measured.push_back(pass["pass"]);
    EXPECT_GT(pass["ratio"].get<double>(), 0.0) << pass;
    EXPECT_GT(pass["copy_ms"].get<double>(), 0.0) << pass;
    EXPECT_GT(pass["items"].get<int>(), 0) << pass;
    EXPECT_EQ(pass["draw_ms"].is_null(), pass["pass"] != "raster");
  }
  EXPECT_EQ(measured, (std::vector<std::string>{"cull", "sort", "project", "raster"}));
}

TEST_F(Commands, BenchMeasuresFloorsOfTheMarch) {
  const json all = json::parse(
      run({"bench", "m.vtu", "--size", "32x32", "--frames", "2", "--max-rmse", "1", "--floor", "--json", "--quiet"})
          .out);
  const json& passes = all[0]["floor"]["passes"];
  ASSERT_EQ(passes.size(), 2u);
  for (const json& pass : passes) {
    for (const char* key : {"ratio", "copy_ms", "empty_ms", "bytes", "items"})
      EXPECT_GT(pass[key].get<double>(), 0.0) << key << " " << pass;
    EXPECT_TRUE(pass["draw_ms"].is_null());
  }
  EXPECT_EQ(passes[0]["pass"], "enter");
  EXPECT_EQ(passes[0]["items"], passes[0]["counts"]["jobs"]);
  EXPECT_GT(passes[0]["counts"]["entries"].get<int>(), 100);
  EXPECT_EQ(passes[1]["pass"], "march");
  EXPECT_EQ(passes[1]["items"], passes[1]["counts"]["cells"]);
  EXPECT_GE(passes[1]["counts"]["parts"].get<int>(), passes[1]["counts"]["cells"].get<int>());
}

TEST_F(Commands, BenchMeasuresSequences) {
  const json all = json::parse(
      run({"bench", "m.vtu", "--size", "32x32", "--frames", "3", "--max-rmse", "1", "--sequence", "--json", "--quiet"})
          .out);
  const json& sequence = all[0]["sequence"];
  EXPECT_EQ(sequence["frames"], 3);
  for (const char* key : {"alone_ms", "in_flight_ms"}) EXPECT_GT(sequence[key].get<double>(), 0.0) << key;
  EXPECT_EQ(
      json::parse(
          run({"bench", "m.vtu", "--size", "32x32", "--frames", "1", "--max-rmse", "1", "--json", "--quiet"}).out)[0]
          .count("sequence"),
      0u);
}

TEST_F(Commands, BenchRefusesAWrongPicture) {
  const auto result = runTetralux({"bench", "m.vtu", "--size", "32x32", "--max-rmse", "0", "--quiet"}, dir_.path());
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("not timed"));
}

TEST_F(Commands, CertifyMeasuresTheFrame) {
  const auto result =
      run({"render", "m.vtu", "--size", "64x48", "-o", "a.exr", "--quiet", "--stats", "s.json", "--certify", "300"});
  EXPECT_THAT(result.out, HasSubstr("certify: 300 of "));
  const json certify = json::parse(readTextFile(dir_ / "s.json"))["certify"];
  EXPECT_EQ(certify["pixels"], 300);
  EXPECT_EQ(certify["over"], 0);
  EXPECT_NEAR(certify["tolerance"].get<double>(), 1.0 / 510.0, 1e-12);
  EXPECT_LE(certify["p99"].get<double>(), certify["max"].get<double>());
  EXPECT_NEAR(certify["share_over_bound"].get<double>(), 1.0 - std::pow(0.01, 1.0 / 300.0), 1e-9);
  for (const char* key :
       {"pixels", "covered_pixels", "seed", "tolerance", "max", "p99", "rmse", "over", "share_over_bound"})
    EXPECT_TRUE(readExrAttribute(dir_ / "a.exr", std::string("tetralux.certify.") + key)) << key;
  EXPECT_EQ(readExrAttribute(dir_ / "a.exr", "tetralux.certify.pixels"), "300");
}

TEST_F(Commands, CertifyRefusesAWrongPictureButWritesIt) {
  dir_.write("peak.json", R"({"points": [{"s": -1, "rgb": [1, 1, 1], "tau": 0}, {"s": 0.49, "rgb": [1, 1, 1], "tau": 0},
                                         {"s": 0.5, "rgb": [1, 1, 1], "tau": 500},
                                         {"s": 0.51, "rgb": [1, 1, 1], "tau": 0}]})");
  const std::vector<std::string> arguments = {"render",  "m.vtu",     "--tf",  "peak.json",    "--size",
                                              "64x48",   "-o",        "p.exr", "--stats",      "s.json",
                                              "--quiet", "--certify", "500",   "--integration"};
  auto average = arguments;
  average.push_back("average");
  const auto wrong = runTetralux(average, dir_.path());
  EXPECT_EQ(wrong.status, 1);
  EXPECT_THAT(wrong.err, HasSubstr("m.vtu: largest error"));
  EXPECT_TRUE(std::filesystem::exists(dir_ / "p.exr"));
  EXPECT_GT(json::parse(readTextFile(dir_ / "s.json"))["certify"]["over"].get<int>(), 0);
  average.insert(average.end(), {"--certify-tolerance", "1"});
  run(average);
  auto exact = arguments;
  exact.push_back("exact");
  run(exact);
}

TEST_F(Commands, CertifyReportsTheWorstFrame) {
  const auto result = run({"render", "m.vtu", "--size", "32x32", "--frames", "3", "-o", "f_%d.exr", "--quiet",
                           "--certify", "100000", "--stats", "s.json"});
  const json certify = json::parse(readTextFile(dir_ / "s.json"))["certify"];
  EXPECT_EQ(certify["frames"], 3);
  double worst = 0.0;
  for (const char* name : {"f_0.exr", "f_1.exr", "f_2.exr"})
    worst = std::max(worst, std::stod(*readExrAttribute(dir_ / name, "tetralux.certify.max")));
  EXPECT_EQ(certify["max"].get<double>(), worst);
  EXPECT_THAT(result.out, HasSubstr("worst of 3 frames"));
}

TEST_F(Commands, InfoCountsWhatTheMeshHolds) {
  const json info = json::parse(run({"info", "m.vtu", "--json"}).out);
  EXPECT_GT(info["cells"].get<int>(), 2000);
  EXPECT_EQ(info["inverted_cells"], 0);
  EXPECT_NEAR(info["volume"].get<double>(), 1.0, 1e-9);
  EXPECT_EQ(info["arrays"][0]["name"], "scalar");
  EXPECT_THAT(run({"info", "m.vtu"}).out, HasSubstr("boundary faces"));
}

TEST_F(Commands, EveryKindOfMeshIsWrittenAndRead) {
  for (const char* kind :
       {"demo", "box", "jittered", "graded", "random", "flattened", "twisted", "slivers", "cycle", "cycle-connected"}) {
    std::vector<std::string> arguments = {"mesh", kind, "-o", "k.vtu", "--quiet"};
    if (kind != std::string("slivers")) arguments.insert(arguments.end(), {"--cells", "2000"});
    run(arguments);
    EXPECT_GT(json::parse(run({"info", "k.vtu", "--json"}).out)["cells"].get<int>(), 0) << kind;
  }
}

TEST_F(Commands, AnyKindOfMeshMayHaveTheDistanceFromItsMiddle) {
  run({"mesh", "box", "--cells", "2000", "--field-function", "sphere", "-o", "k.vtu", "--quiet"});
  const json arrays = json::parse(run({"info", "k.vtu", "--json"}).out)["arrays"];
  ASSERT_EQ(arrays.size(), 2u);
  EXPECT_EQ(arrays[1]["name"], "distance");
}

TEST_F(Commands, StabilityWritesItsThreeFiles) {
  run({"stability", "--out", "new/folder", "--region", "seams", "--region", "one pixel", "--quiet", "--validate"});
  for (const char* name : {"stability.csv", "stability.svg", "stability.html"})
    EXPECT_TRUE(std::filesystem::exists(dir_ / "new/folder" / name)) << name;
  EXPECT_THAT(readTextFile(dir_ / "new/folder/stability.csv"), HasSubstr("\none pixel,projection march,"));
}

TEST_F(Commands, DevicesAreListed) {
  const std::string devices = run({"devices"}).out;
  EXPECT_THAT(devices, HasSubstr("usable             yes"));
  EXPECT_THAT(devices, HasSubstr(" available\n"));
}

TEST_F(Commands, HalfExrAndTargetsAreWritten) {
  run({"render", "m.vtu", "--size", "32x32", "-o", "a.exr", "--quiet"});
  run({"render", "m.vtu", "--size", "32x32", "-o", "h.exr", "--exr-type", "half", "--exr-compression", "piz",
       "--target", "rgba16f", "--quiet"});
  EXPECT_LE(compareImages(readExr(dir_ / "a.exr"), readExr(dir_ / "h.exr")).max, 0.02);
  for (const char* target : {"rgba16f-chunked", "rgba8", "rgba8-dither"}) {
    run({"render", "m.vtu", "--size", "32x32", "-o", "t.exr", "--target", target, "--chunk-cells", "200", "--quiet",
         "--stats", "s.json"});
    EXPECT_EQ(json::parse(readTextFile(dir_ / "s.json"))["target"], target);
    EXPECT_EQ(readExrAttribute(dir_ / "t.exr", "tetralux.target"), target);
    EXPECT_LE(compareImages(readExr(dir_ / "a.exr"), readExr(dir_ / "t.exr")).max, 0.2) << target;
  }
}

TEST_F(Commands, AutoTargetSaysWhatItTook) {
  run({"render", "m.vtu", "--size", "32x32", "-o", "t.exr", "--projection", "pt", "--target", "auto", "--quiet",
       "--stats", "s.json"});
  const json stats = json::parse(readTextFile(dir_ / "s.json"));
  EXPECT_THAT(stats["target"].get<std::string>(), ::testing::AnyOf("rgba32f", "rgba16f"));
  EXPECT_EQ(readExrAttribute(dir_ / "t.exr", "tetralux.target"), stats["target"].get<std::string>());
  EXPECT_GT(stats["ms"]["measure"].get<double>(), 0.0);
}

TEST_F(Commands, CompareShowsWhereTheDifferencesAre) {
  run({"render", "m.vtu", "--size", "40x30", "-o", "a.exr", "--quiet"});
  run({"render", "m.vtu", "--size", "40x30", "-o", "b.exr", "--integration", "average", "--quiet"});
  run({"compare", "a.exr", "b.exr", "--difference", "d.png", "--difference-scale", "d.svg"});
  const Image shown = readPng(dir_ / "d.png");
  EXPECT_EQ(shown.width, 40u);
  float brightest = 0.0f;
  for (const glm::vec4& p : shown.pixels) brightest = std::max({brightest, p.x, p.y, p.z});
  EXPECT_GT(brightest, 0.05f);
  EXPECT_THAT(readTextFile(dir_ / "d.svg"), HasSubstr("<svg"));
  run({"compare", "a.exr", "a.exr", "--difference", "same.png"});
  for (const glm::vec4& p : readPng(dir_ / "same.png").pixels) EXPECT_EQ(glm::vec3(p), glm::vec3(0.0f));
  EXPECT_EQ(runTetralux({"compare", "a.exr", "b.exr", "--difference", "d.txt"}, dir_.path()).status, 2);
}

TEST_F(Commands, ProjectionIsChosenUnlessAskedFor) {
  const auto drawnBy = [&](std::vector<std::string> options) {
    options.insert(options.begin(),
                   {"render", "m.vtu", "--size", "32x32", "-o", "p.exr", "--quiet", "--stats", "s.json"});
    run(options);
    return json::parse(readTextFile(dir_ / "s.json"))["projection"].get<std::string>();
  };
  EXPECT_THAT(drawnBy({}), ::testing::AnyOf("march", "pt"));
  EXPECT_EQ(drawnBy({"--projection", "gator"}), "gator");
  // What only cells that are drawn have.
  EXPECT_THAT(drawnBy({"--order", "radix"}), ::testing::AnyOf("silhouette", "pt"));
  EXPECT_THAT(drawnBy({"--target", "rgba8"}), ::testing::AnyOf("silhouette", "pt"));
  EXPECT_EQ(drawnBy({"--interpolation", "screen"}), "pt");
}

TEST_F(Commands, ToleranceIsKeptAndExplained) {
  for (const char* tolerance : {"1/32", "0.002"}) {
    const auto result = run({"render", "m.vtu", "--size", "48x48", "-o", "t.exr", "--tolerance", tolerance, "--explain",
                             "--certify", "4000", "--stats", "s.json", "--quiet"});
    const json stats = json::parse(readTextFile(dir_ / "s.json"));
    const double value = stats["tolerance"]["value"];
    EXPECT_NEAR(value, std::string(tolerance) == "1/32" ? 1.0 / 32.0 : 0.002, 1e-12);
    EXPECT_EQ(stats["certify"]["tolerance"].get<double>(), value);
    EXPECT_LE(stats["certify"]["max"].get<double>(), value);
    ASSERT_GE(stats["tolerance"]["decisions"].size(), 3u);
    for (const auto& decision : stats["tolerance"]["decisions"])
      EXPECT_THAT(result.out, HasSubstr(decision["choice"].get<std::string>()));
  }
  run({"render", "m.vtu", "--size", "48x48", "-o", "t.exr", "--stats", "s.json", "--quiet"});
  EXPECT_TRUE(json::parse(readTextFile(dir_ / "s.json"))["tolerance"].is_null());
}

TEST_F(Commands, BadTolerancesAreRefused) {
  for (const char* text : {"0", "-1", "2", "1/0", "1/", "x", "1/2/3", ""}) {
    const auto result = runTetralux({"render", "m.vtu", "--tolerance=" + std::string(text)}, dir_.path());
    EXPECT_EQ(result.status, 2) << text;
  }
  EXPECT_EQ(runTetralux({"render", "m.vtu", "--explain"}, dir_.path()).status, 2);
  EXPECT_EQ(runTetralux({"render", "m.vtu", "--tolerance", "0.1", "--integration", "ppi"}, dir_.path()).status, 2);
}

TEST_F(Commands, OpacityScaleMultipliesExtinctions) {
  const auto writeTransfer = [&](const char* name, const std::string& emission, double factor) {
    json transfer = {{"emission", emission}, {"points", json::array()}};
    for (const double s : {-1.0, 0.0, 1.0})
      transfer["points"].push_back({{"s", s}, {"rgb", {0.2, s * s, 0.9}}, {"tau", factor * (1.5 + s)}});
    dir_.write(name, transfer.dump());
  };
  for (const char* emission : {"per_extinction", "per_length"}) {
    writeTransfer("one.json", emission, 1);
    writeTransfer("three.json", emission, 3);
    for (const char* command : {"render", "reference"}) {
      run({command, "m.vtu", "--size", "24x24", "-o", "a.exr", "--tf", "one.json", "--opacity-scale", "3", "--quiet"});
      run({command, "m.vtu", "--size", "24x24", "-o", "b.exr", "--tf", "three.json", "--quiet"});
      run({command, "m.vtu", "--size", "24x24", "-o", "c.exr", "--tf", "one.json", "--quiet"});
      EXPECT_EQ(compareImages(readExr(dir_ / "a.exr"), readExr(dir_ / "b.exr")).max, 0.0) << command;
      EXPECT_GT(compareImages(readExr(dir_ / "a.exr"), readExr(dir_ / "c.exr")).max, 0.01) << command;
    }
  }
}

}  // namespace
}  // namespace tetralux::cli
