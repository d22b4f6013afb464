// Isosurfaces along rays: against the reference, and what has a closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "appearance_views.h"
#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"

namespace tetralux::render {
namespace {

using test::AppearancePair;
using test::drawAppearance;
using test::GpuTest;
using test::surfaceAt;

const TransferFunction kThin({{0.0, {1, 0.2, 0}, 0.1}, {1.0, {0, 0.3, 1}, 0.6}}, "thin");

TEST_F(GpuTest, IsosurfacesAgreeWithTheReference) {
  std::uint32_t turn = 0;
  for (const auto& [name, mesh] : test::hardMeshes()) {
    const ScalarField field = scalarField(mesh, "", "test");
    if (field.association == FieldAssociation::Cell) continue;
    const auto at = [&](double share) { return field.low + share * (field.high - field.low); };
    for (const Camera& camera : test::orderViews(mesh)) {
      const auto shading = static_cast<Shading>(turn++ % 3);
      Appearance appearance;
      appearance.lighting = test::sideLight();
      appearance.volumeVisible = shading != Shading::Flat;
      appearance.isosurfaces = {surfaceAt(at(0.2), 0.3, shading), surfaceAt(at(0.45), 0.6, shading),
                                surfaceAt(at(0.7), 1.0, shading)};
      const AppearancePair pair = drawAppearance(context(), mesh, kThin, appearance, camera);
      const test::SurfaceErrors errors = test::surfaceErrors(pair);
      EXPECT_LE(errors.rmse, 2e-4) << name;
      EXPECT_LE(errors.largest, 1.0 / 255.0) << name;
      EXPECT_LE(errors.over, pair.exact.pixels.size() / 1000) << name;
    }
  }
}

TEST_F(GpuTest, DoublePrecisionDrawsIsosurfacesToo) {
  if (!context().info().hasFloat64) GTEST_SKIP() << "the device has no double precision";
  const TetMesh mesh = randomDelaunay(2000, 7);
  Appearance appearance;
  appearance.isosurfaces = {surfaceAt(0.4, 0.5), surfaceAt(0.6, 1.0)};
  RendererOptions options = test::withProjection(CellProjection::March);
  options.doublePrecision = true;
  const AppearancePair pair =
      drawAppearance(context(), mesh, kThin, appearance, test::orderViews(mesh)[0], test::kAppearanceSize, options);
  EXPECT_LE(pair.difference().rmse, 2e-5);
}

// In the sorted pass: cells are drawn one by one.
TEST_F(GpuTest, IsosurfacesOfSortedCellsAgreeWithTheReference) {
  std::uint32_t turn = 0;
  for (const auto& [name, mesh] : test::hardMeshes()) {
    const ScalarField field = scalarField(mesh, "", "test");
    if (field.association == FieldAssociation::Cell) continue;
    const auto at = [&](double share) { return field.low + share * (field.high - field.low); };
    for (const Camera& camera : test::orderViews(mesh)) {
      if (turn++ % 2 == 1) continue;
      Appearance appearance;
      appearance.lighting = test::sideLight();
      appearance.volumeVisible = turn % 4 == 1;
      appearance.isosurfaces = {surfaceAt(at(0.2), 0.3), surfaceAt(at(0.45), 0.6, Shading::Flat),
                                surfaceAt(at(0.7), 1.0)};
      const AppearancePair pair = drawAppearance(context(), mesh, kThin, appearance, camera, test::kAppearanceSize,
                                                 test::withProjection(CellProjection::Silhouette));
      const test::SurfaceErrors errors = test::surfaceErrors(pair);
      EXPECT_LE(errors.rmse, 2e-4) << name;
      EXPECT_LE(errors.largest, 1.0 / 255.0) << name;
      EXPECT_LE(errors.over, pair.exact.pixels.size() / 1000) << name;
    }
  }
}

// A surface in the mesh's own faces: every ray crosses it once, wherever it is.
TEST_F(GpuTest, ASurfaceInSharedFacesIsMetOnce) {
  const TetMesh mesh = kuhnGrid(8, 8, 8, glm::dvec3(-1), glm::dvec3(1), [](const glm::dvec3& p) { return p.z; });
  Appearance appearance;
  appearance.volumeVisible = false;
  appearance.isosurfaces = {surfaceAt(-0.5, 0.25, Shading::None), surfaceAt(0.25, 0.25, Shading::None)};
  Camera camera;
  camera.eye = {0.31, 0.17, 5.0};
  camera.center = {0.0, 0.0, 0.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.fovyDegrees = 10.0;  // all rays pass through both surfaces
  for (const double direction : {1.0, -1.0}) {
    camera.eye.z = 5.0 * direction;
    for (const CellProjection projection : {CellProjection::March, CellProjection::Silhouette}) {
      const AppearancePair pair = drawAppearance(context(), mesh, kThin, appearance, camera, test::kAppearanceSize,
                                                 test::withProjection(projection));
      for (size_t i = 0; i < pair.drawn.pixels.size(); i++) {
        ASSERT_NEAR(pair.drawn.pixels[i].a, 1.0 - 0.75 * 0.75, 1e-6) << i;
        ASSERT_EQ(pair.crossings[i], 2u) << i;
      }
    }
  }
}

// A layer of cells that has the isovalue itself is met where it begins, and not filled.
TEST_F(GpuTest, APlateauIsMetOnce) {
  const auto plateau = [](const glm::dvec3& p) { return p.z < -0.25 ? p.z + 0.25 : p.z > 0.25 ? p.z - 0.25 : 0.0; };
  const TetMesh mesh = kuhnGrid(4, 4, 8, glm::dvec3(-1), glm::dvec3(1), plateau);
  Appearance appearance;
  appearance.volumeVisible = false;
  appearance.isosurfaces = {surfaceAt(0.0, 0.5, Shading::None)};
  Camera camera;
  camera.center = {0.0, 0.0, 0.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.fovyDegrees = 10.0;
  for (const double z : {5.0, -5.0}) {
    camera.eye = {0.2, 0.1, z};
    for (const glm::vec4& pixel : drawAppearance(context(), mesh, kThin, appearance, camera).drawn.pixels)
      ASSERT_EQ(pixel.a, 0.5f);
  }
}

// The region {s >= v} has a boundary where it touches the mesh's, too, but a ray that is only ever inside crosses
// nothing.
TEST_F(GpuTest, ConstantFieldsHaveNoSurface) {
  const TetMesh mesh = kuhnGrid(3, 3, 3, glm::dvec3(-1), glm::dvec3(1), [](const glm::dvec3&) { return 2.0; });
  Appearance appearance;
  appearance.volumeVisible = false;
  appearance.isosurfaces = {surfaceAt(2.0, 0.5)};
  for (const glm::vec4& pixel :
       drawAppearance(context(), mesh, kThin, appearance, test::orderViews(mesh)[0]).drawn.pixels)
    ASSERT_EQ(pixel, glm::vec4(0.0f));
}

// Rays through a ball meet its surface twice, whatever cells they pass: alpha is one of two values. Only rays that
// graze the surface may differ: linear inside cells, it is not convex there.
TEST_F(GpuTest, ATranslucentSphereHasNoEdges) {
  const TetMesh mesh = jitteredGrid(26, 26, 26, glm::dvec3(-1), glm::dvec3(1), 0.15, 5,
                                    [](const glm::dvec3& p) { return glm::length(p); });
  const ScalarField field = scalarField(mesh, "", "test");
  Appearance appearance;
  appearance.volumeVisible = false;
  appearance.isosurfaces = {surfaceAt(0.6, 0.5, Shading::None)};
  const AppearanceData data = makeAppearanceData(appearance, mesh, field, "test");
  Renderer renderer(context(), mesh, field, test::withProjection(CellProjection::March));
  renderer.setTransferFunction(kThin);
  renderer.setAppearance(appearance, data);
  Camera start;
  start.eye = {0.0, 0.3, 4.0};
  start.center = {0.0, 0.0, 0.0};
  start.up = {0.0, 1.0, 0.0};
  start.fovyDegrees = 24.0;
  const ImageSize size{64, 64};
  const double height = 4.0 * std::tan(0.5 * 24.0 * 3.14159265358979 / 180.0);
  for (int view = 0; view < 360; view++) {
    const Camera camera = start.turned(1.0 * view);
    renderer.draw(camera, size);
    const Image image = renderer.readImage();
    const glm::dvec3 eye = camera.eye;
    for (std::uint32_t y = 0; y < size.height; y++) {
      for (std::uint32_t x = 0; x < size.width; x++) {
        const Ray ray = camera.pixelRay(size, x, y);
        const glm::dvec3 direction = glm::normalize(ray.direction);
        const double distance = glm::length(glm::cross(direction, -eye));
        // Pixels next to the disc's outline, and the cells' deviation from the sphere there.
        const double margin = 2.0 * height / size.height + 0.01;
        if (std::abs(distance - 0.6) < margin) continue;
        const float expected = distance < 0.6 ? 0.75f : 0.0f;
        ASSERT_EQ(image.at(x, y).a, expected) << "view " << view << ", pixel " << x << ", " << y;
      }
    }
  }
}

TEST_F(GpuTest, NormalsOfASphereAreWithinADegree) {
  const TetMesh mesh = jitteredGrid(26, 26, 26, glm::dvec3(-1), glm::dvec3(1), 0.15, 5,
                                    [](const glm::dvec3& p) { return glm::length(p); });
  ASSERT_GE(mesh.cellCount(), 100000u);
  // Three lights of one colour each show the normal's three components.
  Appearance appearance;
  appearance.volumeVisible = false;
  appearance.isosurfaces = {surfaceAt(0.6, 1.0)};
  appearance.isosurfaces[0].rgb = appearance.isosurfaces[0].backRgb = glm::dvec3(1.0);
  appearance.lighting = {.ambient = 0.0, .diffuse = 1.0, .specular = 0.0, .shininess = 1.0, .headLight = false};
  appearance.lighting.lights = {{{1, 0, 0}, {1, 0, 0}}, {{0, 1, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}}};
  Camera camera;
  camera.eye = glm::dvec3(2.6);
  camera.center = {0.0, 0.0, 0.0};
  camera.up = {0.0, 1.0, 0.0};
  camera.fovyDegrees = 17.0;
  const ImageSize size{128, 128};
  const ScalarField field = scalarField(mesh, "", "test");
  const AppearanceData data = makeAppearanceData(appearance, mesh, field, "test");
  Renderer renderer(context(), mesh, field, test::withProjection(CellProjection::March));
  renderer.setTransferFunction(kThin);
  renderer.setAppearance(appearance, data);
  renderer.draw(camera, size);
  const Image image = renderer.readImage();
  size_t seen = 0;
  size_t off = 0;
  for (std::uint32_t y = 0; y < size.height; y++) {
    for (std::uint32_t x = 0; x < size.width; x++) {
      const Ray ray = camera.pixelRay(size, x, y);
      const glm::dvec3 d = glm::normalize(ray.direction);
      const double along = -glm::dot(d, ray.origin);
      const double squared = 0.36 - (glm::dot(ray.origin, ray.origin) - along * along);
      if (squared < 0.02) continue;  // near the outline
      const glm::dvec3 normal = glm::normalize(ray.origin + (along - std::sqrt(squared)) * d);
      if (!(std::min({normal.x, normal.y, normal.z}) > 0.02)) continue;  // a light behind shows nothing
      seen++;
      const glm::dvec3 found = glm::normalize(glm::dvec3(glm::vec3(image.at(x, y))));
      off += glm::dot(found, normal) < std::cos(3.14159265358979 / 180.0) ? 1 : 0;
    }
  }
  EXPECT_GE(seen, 2000u);
  EXPECT_LE(static_cast<double>(off), 0.01 * static_cast<double>(seen));
}

TEST_F(GpuTest, APlainAppearanceChangesNothing) {
  const TetMesh mesh = randomDelaunay(1000, 3);
  const ScalarField field = scalarField(mesh, "", "test");
  const Camera camera = test::orderViews(mesh)[0];
  Renderer renderer(context(), mesh, field, test::withProjection(CellProjection::March));
  renderer.setTransferFunction(kThin);
  renderer.draw(camera, test::kAppearanceSize);
  const Image before = renderer.readImage();
  const MemoryUse plain = renderer.memoryUse();
  renderer.setAppearance(Appearance{}, AppearanceData{});
  renderer.draw(camera, test::kAppearanceSize);
  EXPECT_EQ(before.pixels, renderer.readImage().pixels);
  EXPECT_EQ(renderer.memoryUse().tableBytes, plain.tableBytes);

  // And one that asks for gradients has them: 16 bytes per vertex.
  Appearance lit;
  lit.isosurfaces = {surfaceAt(0.5, 1.0)};
  renderer.setAppearance(lit, makeAppearanceData(lit, mesh, field, "test"));
  renderer.draw(camera, test::kAppearanceSize);
  EXPECT_GE(renderer.memoryUse().tableBytes, plain.tableBytes + 16 * mesh.pointCount());
}

}  // namespace
}  // namespace tetralux::render
