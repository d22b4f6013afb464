#include "scene/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/expect_error.h"
#include "support/shared_data.h"
#include "support/temp_dir.h"

namespace tetralux {
namespace {

using test::errorOf;
using ::testing::HasSubstr;

const std::string kScene = R"({
 "mesh": "sub/m.vtu",
 "field": "density",
 "camera": {"projection": "perspective", "eye": [1, 2, 3], "center": [0, 0, 0], "up": [0, 0, 1], "fovy": 30.5},
 "image": {"width": 64, "height": 48, "background": [0.25, 0.5, 1]},
 "transfer_function": {"points": [{"s": 0, "rgb": [1, 0, 0], "tau": 0}, {"s": 1, "rgb": [0, 1, 0], "tau": 2}]}
})";

Scene parse(const std::string& text) { return parseScene(text, "f.json", "folder"); }

// The scene with one piece of its text replaced.
std::string edited(const std::string& from, const std::string& to) {
  const size_t at = kScene.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return std::string(kScene).replace(at, from.size(), to);
}

TEST(SceneFile, HoldsWhatTheContractSays) {
  const Scene scene = parse(kScene);
  EXPECT_EQ(scene.meshPath, "folder/sub/m.vtu");
  EXPECT_EQ(scene.fieldName, "density");
  EXPECT_EQ(scene.camera.projection, Projection::Perspective);
  EXPECT_EQ(scene.camera.eye, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene.camera.fovyDegrees, 30.5);
  EXPECT_EQ(scene.size.width, 64u);
  EXPECT_EQ(scene.size.height, 48u);
  EXPECT_EQ(scene.background, glm::dvec3(0.25, 0.5, 1));
  EXPECT_EQ(scene.transferFunction.points().size(), 2u);
  EXPECT_EQ(parse(edited("sub/m.vtu", "/abs/m.vtu")).meshPath, "/abs/m.vtu");
}

TEST(SceneFile, OrthographicHasAHeightInsteadOfAnAngle) {
  const std::string text = edited("\"perspective\"", "\"orthographic\"");
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { parse(text); }), "f.json: camera.height: missing, expected a number");
  const std::string whole = std::string(text).replace(text.find("\"fovy\": 30.5"), 12, "\"height\": 7");
  EXPECT_EQ(parse(whole).camera.heightWorld, 7.0);
}

TEST(SceneFile, TransferFunctionMayEmitPerLength) {
  EXPECT_EQ(parse(kScene).transferFunction.emission(), Emission::PerExtinction);
  const Scene scene = parse(edited("{\"points\"", "{\"emission\": \"per_length\", \"points\""));
  EXPECT_EQ(scene.transferFunction.emission(), Emission::PerLength);
}

struct Defect {
  const char* from;
  const char* to;
  const char* message;
};

TEST(SceneFile, EveryDefectIsNamedWithItsPlace) {
  const Defect defects[] = {
      {"\"mesh\": \"sub/m.vtu\",", "", "f.json: mesh: missing, expected a text"},
      {"\"sub/m.vtu\"", "7", "f.json: mesh: found 7, expected a text"},
      {"\"field\": \"density\",", "", "f.json: field: missing, expected a text"},
      {"\"field\"", "\"feild\"", "f.json: field: missing, expected a text"},
      {"\"mesh\"", "\"extra\": 1, \"mesh\"",
       "f.json: extra: unknown key, expected one of boundary_emphasis, camera, "
       "clip, field, image, isosurfaces, lighting, mesh, opacity_by_gradient, rgba_field, second_field, "
       "silhouette_emphasis, surfaces, transfer_function, transfer_function_2d, volume"},
      {"\"eye\"", "\"eye2\": 1, \"eye\"",
       "f.json: camera.eye2: unknown key, expected one of center, eye, fovy, projection, up"},
      {"\"perspective\"", "\"fisheye\"",
       "f.json: camera.projection: found \"fisheye\", expected one of \"perspective\", \"orthographic\""},
      {"[1, 2, 3]", "[1, 2]", "f.json: camera.eye: found [1,2], expected three numbers [x, y, z]"},
      {"[1, 2, 3]", "[1, \"2\", 3]", "f.json: camera.eye[1]: found \"2\", expected a number"},
      {"[1, 2, 3]", "[0, 0, 0]", "f.json: camera: eye and center are both (0, 0, 0), expected two different points"},
      {"30.5", "-1", "f.json: camera: fovy is -1, expected degrees between 0 and 180"},
      {"64", "0", "f.json: image.width: found 0, expected a whole number from 1 to 65536"},
      {"64", "1.5", "f.json: image.width: found 1.5, expected a whole number from 1 to 65536"},
      {"48", "\"48\"", "f.json: image.height: found \"48\", expected a whole number from 1 to 65536"},
      {"0.25, 0.5", "0.25, -0.5", "f.json: image.background[1]: found -0.5, expected a number >= 0"},
      {"{\"width\": 64, \"height\": 48, \"background\": [0.25, 0.5, 1]}", "[]",
       "f.json: image: found [], expected an object {...}"},
      {"\"tau\": 2", "\"tau\": -2",
       "f.json: transfer_function.points: point 1: tau is -2, expected a finite number >= 0"},
      {"\"tau\": 2", "\"alpha\": 2", "f.json: transfer_function.points[1].tau: missing, expected a number"},
      {"\"tau\": 2", "\"tau\": 2, \"a\": 1",
       "f.json: transfer_function.points[1].a: unknown key, expected one of rgb, s, tau"},
      {"\"s\": 1", "\"s\": -1",
       "f.json: transfer_function.points: point 1: s is -1, expected at least that of the point before, 0"},
      {"{\"points\"", "{\"emission\": \"glow\", \"points\"",
       "f.json: transfer_function.emission: found \"glow\", expected one of \"per_extinction\", \"per_length\""},
      {"{\"points\"", "{\"emmission\": \"per_length\", \"points\"",
       "f.json: transfer_function.emmission: unknown key, expected one of emission, points"},
      {"{\"points\": [", "{\"points\": [7, ", "f.json: transfer_function.points[0]: found 7, expected an object {...}"},
      {"\"fovy\": 30.5", "\"fovy\": 30.5, \"fovy\": 31", "f.json: key \"fovy\" occurs twice in one object"},
      {"30.5", "1e999", "f.json: holds a number beyond the range of double precision"},
      {"30.5", "NaN", "f.json: line 4, column 106: not valid JSON"},
  };
  for (const Defect& d : defects)
    EXPECT_EQ(errorOf(ErrorCode::Input, [&] { parse(edited(d.from, d.to)); }), d.message) << d.to;
}

TEST(SceneFile, EveryTruncationIsAnError) {
  for (size_t length = 0; length < kScene.size(); length++)
    EXPECT_NE(errorOf(ErrorCode::Input, [&] { parse(kScene.substr(0, length)); }), "no error") << length;
}

TEST(SceneFile, OtherDocumentsAreErrors) {
  for (const char* text : {"[]", "7", "null", "\"x\"", "{}", "\xff\xfe", "{\"mesh\": \"\xff\"}"})
    EXPECT_NE(errorOf(ErrorCode::Input, [&] { parse(text); }), "no error") << text;
}

TEST(SceneFile, CameraCanBeReadByItself) {
  const test::TempDir dir;
  EXPECT_EQ(readCamera(dir.write("scene.json", kScene)).fovyDegrees, 30.5);
  EXPECT_THAT(errorOf(ErrorCode::Input, [&] { readCamera(dir.write("c.json", "{}")); }),
              HasSubstr("camera: missing, expected an object"));
}

TEST(SceneFile, SharedScenesAreRead) {
  REQUIRE_SHARED("scenes");
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::sharedPath("scenes"))) {
    const Scene scene = readScene(entry.path());
    EXPECT_TRUE(std::filesystem::exists(scene.meshPath)) << entry.path();
    count++;
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace tetralux
