#include "scene/appearance_file.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace tetralux {
namespace {

using test::errorOf;

Appearance parse(const std::string& text) {
  const nlohmann::json document = parseJson(text, "f.json");
  JsonObject root(document, "f.json", "");
  Appearance appearance = parseAppearance(root, "folder");
  root.finish();
  return appearance;
}

std::string messageOf(const std::string& text) {
  return errorOf(ErrorCode::Input, [&] { parse(text); });
}

TEST(AppearanceFile, NothingAskedForChangesNothing) {
  const Appearance appearance = parse("{}");
  EXPECT_TRUE(appearance.volumeVisible);
  EXPECT_TRUE(appearance.isosurfaces.empty());
  EXPECT_TRUE(appearance.clip.empty());
  EXPECT_TRUE(appearance.modulations.empty());
  EXPECT_FALSE(appearance.needsGradients());
}

TEST(AppearanceFile, IsosurfacesAreSortedAndHaveDefaults) {
  const Appearance a = parse(R"({"isosurfaces": [{"value": 2, "rgb": [1, 0, 0], "shading": "flat", "opacity": 0.5},
                                                  {"value": -1, "rgb": [0, 1, 0], "back_rgb": [0, 0, 1]}]})");
  ASSERT_EQ(a.isosurfaces.size(), 2u);
  EXPECT_EQ(a.isosurfaces[0].value, -1.0);
  EXPECT_EQ(a.isosurfaces[0].backRgb, glm::dvec3(0, 0, 1));
  EXPECT_EQ(a.isosurfaces[0].shading, Shading::Phong);
  EXPECT_EQ(a.isosurfaces[0].opacity, 1.0);
  EXPECT_EQ(a.isosurfaces[1].backRgb, glm::dvec3(1, 0, 0));
  EXPECT_EQ(a.isosurfaces[1].shading, Shading::Flat);
  EXPECT_TRUE(a.needsGradients());
}

TEST(AppearanceFile, LightsPointTowardsThemselvesWithUnitLength) {
  const Appearance a =
      parse(R"({"lighting": {"ambient": 0, "head_light": false, "lights": [{"direction": [0, 3, 4]}]}})");
  EXPECT_FALSE(a.lighting.headLight);
  EXPECT_EQ(a.lighting.ambient, 0.0);
  ASSERT_EQ(a.lighting.lights.size(), 1u);
  EXPECT_DOUBLE_EQ(a.lighting.lights[0].direction.z, 0.8);
}

TEST(AppearanceFile, ReadsEveryWayToClassify) {
  const Appearance a = parse(R"({
    "volume": {"visible": true, "shading": "phong"},
    "opacity_by_gradient": {"points": [{"gradient": 1, "factor": 0.5}]},
    "boundary_emphasis": {"sigma": 2, "points": [{"distance": 0, "factor": 1}]},
    "silhouette_emphasis": {"points": [{"cosine": 0.5, "factor": 2}]},
    "second_field": {"field": "t", "points": [{"s": 3, "rgb": [0, 1, 0]}]},
    "transfer_function_2d": {"scalars": [0], "gradients": [0, 1],
                             "samples": [{"rgb": [1, 1, 1], "tau": 2}, {"rgb": [0, 0, 0], "tau": 0}]}})");
  ASSERT_EQ(a.modulations.size(), 4u);
  EXPECT_EQ(a.modulations[0].by, ModulatedBy::GradientMagnitude);
  EXPECT_EQ(a.modulations[1].sigma, 2.0);
  EXPECT_EQ(a.modulations[2].curve.at(0.0).factor, 2.0);
  EXPECT_EQ(a.modulations[3].field, "t");
  EXPECT_EQ(a.modulations[3].curve.at(0.0).rgb, glm::dvec3(0, 1, 0));
  EXPECT_EQ(a.volumeShading, Shading::Phong);
  ASSERT_TRUE(a.transfer2d.has_value());
  EXPECT_EQ(a.transfer2d->at(0.0, 0.5).extinction, 1.0);
}

TEST(AppearanceFile, SurfacesAreFoundFromTheScenesFolder) {
  const Appearance a = parse(R"({"surfaces": [{"mesh": "hull.stl", "rgb": [1, 0, 0]}],
                                 "clip": [{"normal": [0, 0, 2], "offset": 3}]})");
  EXPECT_EQ(a.surfaces.at(0).path, "folder/hull.stl");
  EXPECT_EQ(a.surfaces[0].backRgb, glm::dvec3(1, 0, 0));
  EXPECT_EQ(a.clip.at(0).offset, 3.0);
}

TEST(AppearanceFile, SaysWhatIsWrong) {
  EXPECT_EQ(messageOf(R"({"isosurfaces": [{"value": 1, "rgb": [1, 1, 1], "opacity": 2}]})"),
            "f.json: isosurfaces[0].opacity: found 2, expected a number from 0 to 1");
  EXPECT_EQ(messageOf(R"({"isosurfaces": [{"value": 1, "rgb": [1, 1, 1]}, {"value": 1, "rgb": [1, 0, 1]}]})"),
            "f.json: isosurfaces: found the value 1 twice, expected different values");
  EXPECT_EQ(messageOf(R"({"isosurfaces": [{"value": 1, "rgb": [1, -1, 1]}]})"),
            "f.json: isosurfaces[0].rgb[1]: found -1, expected a number >= 0");
  EXPECT_EQ(messageOf(R"({"clip": [{"normal": [0, 0, 0], "offset": 1}]})"),
            "f.json: clip[0].normal: found a vector of length 0, expected a finite length > 0");
  EXPECT_EQ(messageOf(R"({"lighting": {"shininess": 0.5}})"),
            "f.json: lighting.shininess: found 0.5, expected a number >= 1");
  EXPECT_EQ(messageOf(R"({"volume": {"visible": 1}})"), "f.json: volume.visible: found 1, expected true or false");
  EXPECT_EQ(
      messageOf(
          R"({"rgba_field": {"rgb": "c", "extinction": "t"}, "transfer_function_2d": {"scalars": [0], "gradients": [0],
                          "samples": [{"rgb": [0, 0, 0], "tau": 1}]}})"),
      "f.json: transfer_function_2d: found it beside rgba_field, expected one of the two");
}

}  // namespace
}  // namespace tetralux
