// Lighting, classification by more than a scalar, clip planes and opaque surfaces along rays, against the reference.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "appearance_views.h"
#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"
#include "support/expect_error.h"

namespace tetralux::render {
namespace {

using test::drawAppearance;
using test::GpuTest;
using test::surfaceAt;

const TransferFunction kFog({{0.0, {1, 0.2, 0}, 0.2}, {0.5, {0.2, 1, 0.4}, 2.0}, {1.0, {0, 0.3, 1}, 0.6}}, "fog");
const TransferFunction kGlow({{0.0, {1, 0.2, 0}, 0.2}, {0.6, {0.2, 1, 0.4}, 1.0}, {1.0, {0, 0.3, 1}, 0.6}}, "glow",
                             Emission::PerLength);

// A mesh with everything that can be asked for: a second field, and colour and extinction of their own.
const TetMesh& richMesh() {
  static const TetMesh mesh = [] {
    TetMesh m = jitteredGrid(7, 7, 7, glm::dvec3(-1), glm::dvec3(1), 0.15, 3, waveField);
    addPointField(m, "heat", [](const glm::dvec3& p) { return 10.0 + 5.0 * std::sin(2.0 * p.x + p.y); });
    addPointField(m, "density", [](const glm::dvec3& p) { return 1.0 + p.z; });
    std::vector<double> color;
    for (size_t i = 0; i < m.pointCount(); i++) {
      const glm::dvec3 p = m.point(i);
      for (const double c : {p.x, p.y, p.z}) color.push_back(0.5 + 0.5 * c);
    }
    m.pointArrays.push_back({"color", 3, color});
    return m;
  }();
  return mesh;
}

struct NamedAppearance {
  std::string name;
  Appearance appearance;
};

std::vector<NamedAppearance> appearances() {
  std::vector<NamedAppearance> result;
  const auto add = [&](const std::string& name) -> Appearance& {
    result.push_back({name, {}});
    result.back().appearance.lighting = test::sideLight();
    return result.back().appearance;
  };
  const FactorCurve rising(
      {{0.0, 0.1, {1, 1, 1}}, {2.0, 2.0, {0.3, 1, 0.5}}, {2.0, 1.0, {1, 0, 0}}, {4.0, 1.5, {1, 1, 1}}}, "curve");
  add("lit").volumeShading = Shading::Phong;
  add("gradient").modulations = {{ModulatedBy::GradientMagnitude, "", {}, rising}};
  add("boundary").modulations = {
      {ModulatedBy::BoundaryDistance, "", 0.1, FactorCurve({{-0.2, 0.0}, {0.0, 3.0}, {0.2, 0.0}}, "curve")}};
  add("silhouette").modulations = {
      {ModulatedBy::ViewCosine, "", {}, FactorCurve({{0.0, 2.0}, {0.4, 0.2}, {1.0, 0.0}}, "curve")}};
  add("second field").modulations = {
      {ModulatedBy::Field, "heat", {}, FactorCurve({{6.0, 0.0}, {10.0, 2.0, {1, 0.2, 0.2}}, {14.0, 0.5}}, "curve")}};
  add("own colours").rgbaField = RgbaField{"color", "density"};
  add("two dimensions").transfer2d = TransferFunction2d(
      {0.1, 0.5, 0.9}, {0.0, 3.0},
      {{{1, 0, 0}, 0.5}, {{0, 1, 0}, 2.0}, {{0, 0, 1}, 0.0}, {{1, 1, 0}, 0.0}, {{0, 1, 1}, 1.0}, {{1, 0, 1}, 3.0}},
      "2-d");
  Appearance& all = add("everything");
  all.volumeShading = Shading::Phong;
  all.modulations = {result[1].appearance.modulations[0], result[3].appearance.modulations[0],
                     result[4].appearance.modulations[0]};
  all.isosurfaces = {surfaceAt(0.35, 0.3), surfaceAt(0.6, 0.4, Shading::Flat)};
  all.clip = {{{1.0, 0.4, 0.1}, -0.4}, {{0.0, -3.0, 0.5}, -2.0}};
  return result;
}

TEST_F(GpuTest, EveryWayToClassifyAgreesWithTheReference) {
  for (const auto& [name, appearance] : appearances()) {
    const std::vector<Camera> views = test::orderViews(richMesh());
    for (size_t view = 0; view < views.size(); view++) {
      // Both ways to emit, both ways to project, from outside and from inside.
      const TransferFunction& transfer = (view + view / 2) % 2 == 0 ? kFog : kGlow;
      const ImageDifference d = drawAppearance(context(), richMesh(), transfer, appearance, views[view]).difference();
      EXPECT_LE(d.rmse, 2e-4) << name;
      EXPECT_LE(d.max, 2.0 / 255.0) << name;
    }
  }
}

TEST_F(GpuTest, SortedCellsAreClassifiedAlike) {
  for (const auto& [name, appearance] : appearances()) {
    for (const size_t view : {1u, 2u}) {
      const ImageDifference d = drawAppearance(context(), richMesh(), view == 1 ? kFog : kGlow, appearance,
                                               test::orderViews(richMesh())[view], test::kAppearanceSize,
                                               test::withProjection(CellProjection::Silhouette))
                                    .difference();
      EXPECT_LE(d.rmse, 2e-4) << name;
      EXPECT_LE(d.max, 2.0 / 255.0) << name;
    }
  }
}

TEST_F(GpuTest, ClipPlanesCutCellsExactly) {
  Appearance appearance;
  appearance.clip = {{{0.3, -0.2, 1.0}, -0.3}, {{0.0, 2.0, 0.0}, -0.8}, {{-1.0, 0.0, 0.3}, -0.5}};
  size_t turn = 0;
  for (const auto& [name, mesh] : test::hardMeshes()) {
    for (const Camera& camera : test::orderViews(mesh)) {
      if (turn++ % 3 != 0) continue;  // each kind of view with a third of the meshes
      const ImageDifference d = drawAppearance(context(), mesh, kFog, appearance, camera).difference();
      EXPECT_LE(d.rmse, 5e-6) << name;
      EXPECT_LE(d.max, 1e-3) << name;
    }
  }
  // A box of one extinction, cut: what is left of it has a closed form.
  const TetMesh box = kuhnGrid(3, 3, 3, glm::dvec3(-1), glm::dvec3(1), [](const glm::dvec3&) { return 0.0; });
  const TransferFunction even({{0.0, {1, 1, 1}, 0.5}}, "even");
  Camera camera;
  camera.projection = Projection::Orthographic;
  camera.eye = {0.0, 0.0, 5.0};
  camera.center = {0.0, 0.0, 0.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.heightWorld = 1.0;
  appearance.clip = {{{0.0, 0.0, -2.0}, -0.5}, {{0.0, 0.0, 1.0}, -0.7}};  // z from -0.7 to 0.25
  for (const glm::vec4& pixel : drawAppearance(context(), box, even, appearance, camera).drawn.pixels)
    ASSERT_NEAR(pixel.a, 1.0 - std::exp(-0.5 * 0.95), 2e-6);
  // Planes along the rays keep all or nothing.
  appearance.clip = {{{1.0, 0.0, 0.0}, -5.0}};
  for (const glm::vec4& pixel : drawAppearance(context(), box, even, appearance, camera).drawn.pixels)
    ASSERT_NEAR(pixel.a, 1.0 - std::exp(-1.0), 2e-6);
  appearance.clip = {{{1.0, 0.0, 0.0}, 5.0}};
  for (const glm::vec4& pixel : drawAppearance(context(), box, even, appearance, camera).drawn.pixels)
    ASSERT_EQ(pixel, glm::vec4(0.0f));
}

// A ball of triangles, anticlockwise from outside.
OpaqueSurface ball(const glm::dvec3& center, double radius, std::uint32_t rings) {
  OpaqueSurface surface;
  surface.rgb = {0.9, 0.6, 0.2};
  surface.backRgb = {0.1, 0.3, 0.9};
  const std::uint32_t columns = 2 * rings;
  for (std::uint32_t i = 0; i <= rings; i++) {
    for (std::uint32_t j = 0; j < columns; j++) {
      const double theta = std::numbers::pi * i / rings;
      const double phi = 2.0 * std::numbers::pi * j / columns;
      const glm::dvec3 n(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      surface.points.push_back(center + radius * n);
      surface.normals.push_back(n);
    }
  }
  for (std::uint32_t i = 0; i < rings; i++) {
    for (std::uint32_t j = 0; j < columns; j++) {
      const std::uint32_t a = i * columns + j;
      const std::uint32_t b = i * columns + (j + 1) % columns;
      if (i > 0) surface.triangles.push_back({a, a + columns, b});
      if (i + 1 < rings) surface.triangles.push_back({b, a + columns, b + columns});
    }
  }
  return surface;
}

TEST_F(GpuTest, OpaqueSurfacesEndRaysInsideCells) {
  AppearanceData data;
  Appearance appearance;
  appearance.lighting = test::sideLight();
  for (const Shading shading : {Shading::None, Shading::Flat, Shading::Phong}) {
    OpaqueSurface surface = ball({0.3 * static_cast<double>(shading) - 0.3, 0.1, -0.2}, 0.45, 12);
    surface.shading = shading;
    data.surfaces.push_back(surface);
    appearance.surfaces.push_back({"", surface.rgb, surface.backRgb, shading});
  }
  OpaqueSurface beside = ball({1.6, 0.4, 0.2}, 0.3, 6);  // outside of the mesh
  data.surfaces.push_back(beside);
  appearance.surfaces.push_back({"", beside.rgb, beside.backRgb, Shading::Flat});
  const TetMesh& mesh = richMesh();
  const ScalarField field = scalarField(mesh, "", "test");
  for (const bool isClipped : {false, true}) {
    if (isClipped) appearance.clip = {{{0.0, 1.0, 0.2}, -0.1}};
    for (const Camera& camera : test::orderViews(mesh)) {
      const test::AppearancePair pair = test::drawPair(context(), mesh, field, kFog, appearance, data, camera);
      // Rays that touch an outline may meet either side of it.
      EXPECT_LE(test::surfaceErrors(pair).over, pair.exact.pixels.size() / 500);
    }
  }
}

// No ray gets through a closed surface, whatever edges and vertices it meets.
TEST_F(GpuTest, ClosedSurfacesAreTight) {
  const TetMesh mesh = kuhnGrid(1, 1, 1, glm::dvec3(-1), glm::dvec3(1), waveField);
  const ScalarField field = scalarField(mesh, "", "test");
  Appearance appearance;
  appearance.volumeVisible = false;
  AppearanceData data;
  data.surfaces = {ball(glm::dvec3(0.0), 0.8, 16)};
  appearance.surfaces = {{"", glm::dvec3(1), glm::dvec3(1), Shading::Flat}};
  Renderer renderer(context(), mesh, field, test::withProjection(CellProjection::March));
  renderer.setTransferFunction(kFog);
  renderer.setAppearance(appearance, data);
  Camera camera;
  camera.projection = Projection::Orthographic;
  camera.eye = {0.0, 0.0, 5.0};
  camera.center = {0.0, 0.0, 0.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.heightWorld = 1.0;
  for (const ImageSize size : {ImageSize{64, 64}, ImageSize{63, 65}}) {
    renderer.draw(camera, size);
    for (const glm::vec4& pixel : renderer.readImage().pixels) ASSERT_EQ(pixel.a, 1.0f);
  }
}

TEST_F(GpuTest, CellFieldsAreClippedToo) {
  TetMesh mesh = kuhnGrid(4, 4, 4, glm::dvec3(-1), glm::dvec3(1), waveField);
  std::vector<double> values;
  for (size_t i = 0; i < mesh.cellCount(); i++) values.push_back(static_cast<double>(i % 7) / 6.0);
  mesh.cellArrays.push_back({"parity", 1, values});
  mesh.preferredField = "parity";
  mesh.pointArrays.clear();
  Appearance appearance;
  appearance.clip = {{{0.3, -0.2, 1.0}, -0.3}};
  for (const Camera& camera : test::orderViews(mesh))
    EXPECT_LE(drawAppearance(context(), mesh, kFog, appearance, camera).difference().rmse, 5e-6);
}

TEST_F(GpuTest, OtherProjectionsAndMethodsRefuseMoreThanAVolume) {
  const TetMesh mesh = randomDelaunay(200, 3);
  const ScalarField field = scalarField(mesh, "", "test");
  Appearance appearance;
  appearance.isosurfaces = {surfaceAt(0.5, 1.0)};
  const AppearanceData data = makeAppearanceData(appearance, mesh, field, "test");
  Renderer cells(context(), mesh, field, test::withProjection(CellProjection::Pt));
  cells.setTransferFunction(kFog);
  EXPECT_EQ(test::errorOf(ErrorCode::Usage, [&] { cells.setAppearance(appearance, data); }),
            "--projection: found 'pt' with more than a volume to show, expected march, or silhouette without surfaces");
  Renderer rays(context(), mesh, field, test::withProjection(CellProjection::March));
  rays.setTransferFunction(kFog);
  rays.setAppearance(appearance, data);
  RenderOptions options;
  options.integration = Integration::Linear;
  EXPECT_EQ(test::errorOf(ErrorCode::Usage,
                          [&] {
                            rays.draw(test::orderViews(mesh)[0], {32, 32}, options);
                          }),
            "--integration: found 'linear' with more than a volume to show, expected exact");
}

}  // namespace
}  // namespace tetralux::render
