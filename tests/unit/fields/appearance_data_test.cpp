#include "fields/appearance_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "fields/boundary_distance.h"
#include "mesh/generate.h"
#include "support/expect_error.h"
#include "support/temp_dir.h"

namespace tetralux {
namespace {

using ::testing::AllOf;
using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::SizeIs;

const glm::dvec3 kSlope(1.0, -2.0, 2.0);

// A linear scalar "s", a point array "other", colours, and arrays that are of the wrong kind.
TetMesh testMesh() {
  TetMesh mesh = kuhnGrid(
      2, 2, 2, {0, 0, 0}, {1, 1, 1}, [](const glm::dvec3& p) { return glm::dot(kSlope, p); }, "s");
  const size_t points = mesh.pointCount();
  std::vector<float> rgb;
  for (size_t i = 0; i < points; i++) rgb.insert(rgb.end(), {0.25f * static_cast<float>(i), -1.0f, 2.0f});
  mesh.pointArrays.push_back({"color", 3, std::move(rgb)});
  mesh.pointArrays.push_back({"other", 1, std::vector<std::uint8_t>(points, 7)});
  mesh.cellArrays.push_back({"part", 1, std::vector<double>(mesh.cellCount(), 1.0)});
  return mesh;
}

AppearanceData dataOf(const Appearance& appearance, const TetMesh& mesh = testMesh(), const char* field = "s") {
  return makeAppearanceData(appearance, mesh, scalarField(mesh, field, "m.vtu"), "m.vtu");
}

std::string errorOf(const Appearance& appearance, const TetMesh& mesh = testMesh(), const char* field = "s") {
  return test::errorOf(ErrorCode::Input, [&] { dataOf(appearance, mesh, field); });
}

Appearance modulatedBy(ModulatedBy by) {
  Appearance appearance;
  appearance.modulations.resize(1);
  appearance.modulations[0].by = by;
  if (by == ModulatedBy::Field) appearance.modulations[0].field = "other";
  return appearance;
}

Appearance withRgba(const char* rgb, const char* extinction) {
  Appearance appearance;
  appearance.rgbaField = RgbaField{rgb, extinction};
  return appearance;
}

Appearance withTransfer2d() {
  Appearance appearance;
  appearance.transfer2d = TransferFunction2d({0, 1}, {0}, std::vector<OpticalSample>(2), "t");
  return appearance;
}

void expectEmpty(const AppearanceData& data) {
  EXPECT_TRUE(data.gradients.empty());
  for (const auto& modulator : data.modulators) EXPECT_TRUE(modulator.empty());
  EXPECT_TRUE(data.gradientMagnitudes.empty());
  EXPECT_TRUE(data.rgba.empty());
  EXPECT_TRUE(data.surfaces.empty());
}

TEST(AppearanceData, NothingIsMadeForAPlainVolume) {
  const AppearanceData data = dataOf({});
  expectEmpty(data);
  EXPECT_TRUE(data.modulators.empty());
  expectEmpty(dataOf({}, testMesh(), "part"));
}

TEST(AppearanceData, OnlyPhongSurfacesNeedGradients) {
  Appearance appearance;
  appearance.isosurfaces.resize(1);
  for (const Shading shading : {Shading::None, Shading::Flat}) {
    appearance.isosurfaces[0].shading = shading;
    expectEmpty(dataOf(appearance));
  }
  appearance.isosurfaces[0].shading = Shading::Phong;
  const AppearanceData data = dataOf(appearance);
  ASSERT_EQ(data.gradients.size(), testMesh().pointCount());
  for (const glm::dvec3& g : data.gradients) EXPECT_LT(glm::distance(g, kSlope), 1e-12);
}

TEST(AppearanceData, ModulatorsAreWhatTheirNamesSay) {
  const AppearanceData magnitude = dataOf(modulatedBy(ModulatedBy::GradientMagnitude));
  EXPECT_THAT(magnitude.modulators.at(0), Each(DoubleNear(3.0, 1e-12)));
  const AppearanceData second = dataOf(modulatedBy(ModulatedBy::Field));
  EXPECT_THAT(second.modulators.at(0), AllOf(SizeIs(testMesh().pointCount()), Each(7.0)));
  EXPECT_TRUE(second.gradients.empty());
  const AppearanceData cosine = dataOf(modulatedBy(ModulatedBy::ViewCosine));
  EXPECT_TRUE(cosine.modulators.at(0).empty());
  EXPECT_FALSE(cosine.gradients.empty());
}

TEST(AppearanceData, BoundaryDistancesTakeTheSigmaThatIsGiven) {
  const TetMesh mesh = kuhnGrid(6, 6, 6, {0, 0, 0}, {1, 1, 1}, waveField, "s");
  const GradientFit fit(mesh);
  const auto gradients = fit.gradients(scalarField(mesh, "s", "m.vtu").values);
  Appearance appearance = modulatedBy(ModulatedBy::BoundaryDistance);
  for (const std::optional<double> sigma : {std::optional<double>(), std::optional<double>(0.1)}) {
    appearance.modulations[0].sigma = sigma;
    EXPECT_EQ(dataOf(appearance, mesh).modulators.at(0),
              boundaryDistances(fit, gradients, sigma, mesh.bounds().diagonal()).distances);
  }
}

TEST(AppearanceData, EveryModulationHasItsPlace) {
  Appearance appearance = modulatedBy(ModulatedBy::ViewCosine);
  appearance.modulations.push_back(modulatedBy(ModulatedBy::Field).modulations[0]);
  appearance.modulations.push_back(modulatedBy(ModulatedBy::GradientMagnitude).modulations[0]);
  const AppearanceData data = dataOf(appearance);
  ASSERT_EQ(data.modulators.size(), 3u);
  EXPECT_TRUE(data.modulators[0].empty());
  EXPECT_EQ(data.modulators[1].at(0), 7.0);
  EXPECT_NEAR(data.modulators[2].at(0), 3.0, 1e-12);
}

TEST(AppearanceData, GradientMagnitudesAreForTransferFunctionsOfTwoDimensions) {
  const AppearanceData data = dataOf(withTransfer2d());
  ASSERT_EQ(data.gradientMagnitudes.size(), testMesh().pointCount());
  EXPECT_THAT(data.gradientMagnitudes, Each(DoubleNear(3.0, 1e-12)));
}

TEST(AppearanceData, RgbaTakesTwoArraysAndNegativeNumbersAsZero) {
  const AppearanceData data = dataOf(withRgba("color", "s"));
  const TetMesh mesh = testMesh();
  ASSERT_EQ(data.rgba.size(), mesh.pointCount());
  for (size_t i = 0; i < data.rgba.size(); i++) {
    const double s = mesh.pointArrays[0].value(i);
    EXPECT_EQ(data.rgba[i], glm::dvec4(0.25 * static_cast<double>(i), 0.0, 2.0, std::max(0.0, s)));
  }
  EXPECT_TRUE(data.gradients.empty());
}

TEST(AppearanceData, WhatBelongsToAVolumeThatIsNotVisibleIsNotMade) {
  for (Appearance appearance : {modulatedBy(ModulatedBy::GradientMagnitude), modulatedBy(ModulatedBy::Field),
                                withRgba("color", "s"), modulatedBy(ModulatedBy::BoundaryDistance), withTransfer2d()}) {
    appearance.volumeVisible = false;
    const AppearanceData data = dataOf(appearance);
    expectEmpty(data);
    EXPECT_EQ(data.modulators.size(), appearance.modulations.size());
  }
}

TEST(AppearanceData, AFieldOfCellsIsRefusedWherePointsAreNeeded) {
  const auto expected = [](const char* need) {
    return std::string("m.vtu: field 'part' has one number per cell, expected one per point for ") + need;
  };
  Appearance isosurface;
  isosurface.isosurfaces.resize(1);
  isosurface.isosurfaces[0].shading = Shading::None;
  EXPECT_EQ(errorOf(isosurface, testMesh(), "part"), expected("isosurfaces"));
  Appearance phong;
  phong.volumeShading = Shading::Phong;
  EXPECT_EQ(errorOf(phong, testMesh(), "part"), expected("shading of the volume"));
  EXPECT_EQ(errorOf(modulatedBy(ModulatedBy::GradientMagnitude), testMesh(), "part"), expected("opacity_by_gradient"));
  EXPECT_EQ(errorOf(modulatedBy(ModulatedBy::BoundaryDistance), testMesh(), "part"), expected("boundary_emphasis"));
  EXPECT_EQ(errorOf(modulatedBy(ModulatedBy::ViewCosine), testMesh(), "part"), expected("silhouette_emphasis"));
  EXPECT_EQ(errorOf(withTransfer2d(), testMesh(), "part"), expected("transfer_function_2d"));
}

TEST(AppearanceData, ASecondFieldMayStandBesideAFieldOfCells) {
  EXPECT_EQ(dataOf(modulatedBy(ModulatedBy::Field), testMesh(), "part").modulators.at(0).at(0), 7.0);
}

TEST(AppearanceData, MissingAndUnfitArraysAreNamed) {
  Appearance second = modulatedBy(ModulatedBy::Field);
  second.modulations[0].field = "heat";
  const std::string arrays = "the mesh has 's', 'color', 'other', 'part' (cells)";
  EXPECT_EQ(errorOf(second), "m.vtu: no array 'heat', " + arrays);
  second.modulations[0].field = "part";
  EXPECT_EQ(errorOf(second), "m.vtu: field 'part' has one number per cell, expected one per point for second_field");
  second.modulations[0].field = "";
  EXPECT_EQ(errorOf(second), "m.vtu: found no name of an array, expected one for second_field");
  EXPECT_EQ(errorOf(withRgba("rgb", "s")), "m.vtu: no array 'rgb', " + arrays);
  EXPECT_EQ(errorOf(withRgba("color", "tau")), "m.vtu: no array 'tau', " + arrays);
  EXPECT_EQ(errorOf(withRgba("color", "part")),
            "m.vtu: field 'part' has one number per cell, expected one per point for rgba_field");
  EXPECT_EQ(errorOf(withRgba("s", "s")), "m.vtu: array 's' has 1 components, expected 3 for rgba_field");
  EXPECT_EQ(errorOf(withRgba("color", "color")), "m.vtu: array 'color' has 3 components, expected 1 for rgba_field");
}

TEST(AppearanceData, NumbersThatAreNotFiniteAreRefused) {
  TetMesh mesh = testMesh();
  std::get<std::vector<float>>(mesh.pointArrays[1].values)[3 * 4 + 2] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(errorOf(withRgba("color", "s"), mesh),
            "m.vtu: array 'color': point 4: value is inf, expected a finite number");
  Appearance second = modulatedBy(ModulatedBy::Field);
  second.modulations[0].field = "color";
  EXPECT_EQ(errorOf(second, mesh), "m.vtu: array 'color': point 4: value is inf, expected a finite number");
}

// A triangle in the plane z = 0 and one of twice its area in the plane y = 0, with an edge in common.
constexpr const char* kCorner = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nf 1 2 3\nf 1 4 2\n";

TEST(AppearanceData, NormalsOfSurfacesAreAreaWeightedMeans) {
  const test::TempDir dir;
  Appearance appearance;
  appearance.surfaces.push_back({dir.write("corner.obj", kCorner), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)});
  for (const Shading shading : {Shading::None, Shading::Flat, Shading::Phong}) {
    appearance.surfaces[0].shading = shading;
    const AppearanceData data = dataOf(appearance);
    ASSERT_EQ(data.surfaces.size(), 1u);
    const OpaqueSurface& surface = data.surfaces[0];
    EXPECT_EQ(surface.shading, shading);
    EXPECT_EQ(surface.rgb, glm::dvec3(1, 0, 0));
    EXPECT_EQ(surface.backRgb, glm::dvec3(0, 1, 0));
    EXPECT_EQ(surface.points.size(), 4u);
    EXPECT_EQ(surface.triangles.size(), 2u);
    EXPECT_TRUE(data.gradients.empty());
    if (shading != Shading::Phong) {
      EXPECT_TRUE(surface.normals.empty());
      continue;
    }
    ASSERT_EQ(surface.normals.size(), 4u);
    const auto direction = [&](size_t i) { return glm::normalize(surface.normals[i]); };
    EXPECT_LT(glm::distance(direction(0), glm::normalize(glm::dvec3(0, 2, 1))), 1e-15);
    EXPECT_LT(glm::distance(direction(1), glm::normalize(glm::dvec3(0, 2, 1))), 1e-15);
    EXPECT_EQ(direction(2), glm::dvec3(0, 0, 1));
    EXPECT_EQ(direction(3), glm::dvec3(0, 1, 0));
  }
}

TEST(AppearanceData, AMissingSurfaceIsAnError) {
  Appearance appearance;
  appearance.surfaces.push_back({"none.stl"});
  EXPECT_EQ(errorOf(appearance), "none.stl: no such file");
}

}  // namespace
}  // namespace tetralux
