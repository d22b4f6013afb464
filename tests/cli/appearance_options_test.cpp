// Isosurfaces, clip planes and scenes with more than a volume, as a user asks for them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "cli/appearance_options.h"
#include "image/image_io.h"
#include "image/metrics.h"
#include "support/expect_error.h"
#include "support/run_program.h"
#include "support/temp_dir.h"

namespace tetralux::cli {
namespace {

using test::errorOf;
using test::runTetralux;
using ::testing::HasSubstr;

TEST(AppearanceOptions, AnIsosurfaceHasAValueAColourAndAnOpacity) {
  const Isosurface plain = parseIsosurface("-1.5e-3");
  EXPECT_EQ(plain.value, -1.5e-3);
  EXPECT_EQ(plain.opacity, 1.0);
  const Isosurface full = parseIsosurface("2:ff0080:0.25");
  EXPECT_EQ(full.value, 2.0);
  EXPECT_EQ(full.rgb.x, 1.0);
  EXPECT_EQ(full.rgb.y, 0.0);
  EXPECT_NEAR(full.rgb.z, 0.2158605, 1e-6);  // sRGB 128 in linear light
  EXPECT_EQ(full.backRgb, full.rgb);
  EXPECT_EQ(full.opacity, 0.25);
  for (const char* wrong : {"", "x", "1:", "1:ff00", "1:gg0000", "1:ff0000:2", "1:ff0000:-1", "1:ff0000:1:1", "nan"}) {
    EXPECT_THAT(errorOf(ErrorCode::Usage, [&] { parseIsosurface(wrong); }),
                HasSubstr(std::string("--iso: found '") + wrong + "', expected VALUE"));
  }
}

TEST(AppearanceOptions, AClipPlaneIsFourNumbers) {
  const ClipPlane plane = parseClipPlane("1,0,-2.5,3e2");
  EXPECT_EQ(plane.normal, glm::dvec3(1.0, 0.0, -2.5));
  EXPECT_EQ(plane.offset, 300.0);
  for (const char* wrong : {"", "1,2,3", "0,0,0,1", "1,0,0,x", "1,0,0,1,1"}) {
    EXPECT_THAT(errorOf(ErrorCode::Usage, [&] { parseClipPlane(wrong); }),
                HasSubstr(std::string("--clip: found '") + wrong + "', expected NX,NY,NZ,OFFSET"));
  }
}

class AppearanceCommands : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(run({"mesh", "random", "--cells", "3000", "-o", "m.vtu", "--quiet"}).status, 0); }

  test::ProgramResult run(const std::vector<std::string>& arguments) { return runTetralux(arguments, dir_.path()); }

  test::TempDir dir_;
};

TEST_F(AppearanceCommands, RenderAndReferenceDrawTheSame) {
  const std::vector<std::string> what = {"m.vtu", "--size", "64x48",  "--iso",     "0.4:ff8020:0.5",
                                         "--iso", "0.7",    "--clip", "1,0,0,0.3", "--quiet"};
  const auto with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), what.begin(), what.end());
    const auto result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.err;
  };
  with({"render", "-o", "a.exr", "--validate", "--certify", "3072", "--certify-tolerance", "0.004"});
  with({"reference", "-o", "b.exr"});
  EXPECT_LE(compareImages(readExr(dir_ / "b.exr"), readExr(dir_ / "a.exr")).rmse, 2e-4);
  with({"render", "-o", "c.exr", "--no-volume"});
  EXPECT_GT(compareImages(readExr(dir_ / "c.exr"), readExr(dir_ / "a.exr")).rmse, 1e-3);
}

TEST_F(AppearanceCommands, ASceneMayNeedNoTransferFunction) {
  const std::string scene = R"({"mesh": "m.vtu", "field": "scalar", "camera": {"projection": "perspective",
    "eye": [3, 2, 1.5], "center": [0.5, 0.5, 0.5], "up": [0, 0, 1], "fovy": 25}, "image": {"width": 48, "height": 36},
    "volume": {"visible": false}, "isosurfaces": [{"value": 0.5, "rgb": [0.8, 0.8, 0.8]}]})";
  writeFile(dir_ / "s.json", scene);
  EXPECT_EQ(run({"bench", "s.json", "--frames", "2", "--warmup", "1", "--quiet"}).status, 0);
  const auto chart = run({"chart", "s.json", "--out", "chart", "--quiet"});
  EXPECT_EQ(chart.status, 2);
  EXPECT_THAT(chart.err, HasSubstr("s.json: found more than a volume to show, expected"));
}

TEST_F(AppearanceCommands, WhatCannotBeDrawnIsSaid) {
  const auto cells = run({"render", "m.vtu", "--size", "32x24", "--iso", "0.5", "--projection", "pt", "-o", "a.png"});
  EXPECT_EQ(cells.status, 2);
  EXPECT_THAT(
      cells.err,
      HasSubstr(
          "--projection: found 'pt' with more than a volume to show, expected march, or silhouette without surfaces"));
  const auto twice = run({"render", "m.vtu", "--iso", "0.5", "--iso", "0.5", "-o", "a.png"});
  EXPECT_EQ(twice.status, 3);
  EXPECT_THAT(twice.err, HasSubstr("--iso: found the value 0.5 twice, expected different values"));
  EXPECT_FALSE(std::filesystem::exists(dir_ / "a.png"));
}

}  // namespace
}  // namespace tetralux::cli
