// Rays that walk through the mesh: where a walk of its own may go wrong. What all projections have to draw:
// projection_test.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"

namespace tetralux::render {
namespace {

using test::GpuTest;
using test::projectedImage;
using test::projectionError;
using test::withProjection;

const RendererOptions kMarch = withProjection(CellProjection::March);

void expectFinite(const Image& image) {
  for (const glm::vec4& p : image.pixels) {
    for (int c = 0; c < 4; c++) ASSERT_TRUE(std::isfinite(p[c]));
    ASSERT_GE(p.w, 0.0f);
    ASSERT_LE(p.w, 1.0f);
  }
}

// Rays along edges, through vertices and along faces: views along the axes of a grid whose pixels' centres fall on its
// lines.
TEST_F(GpuTest, MarchGoesThroughEdgesAndVertices) {
  const TetMesh mesh = kuhnGrid(8, 8, 8, glm::dvec3(-1), glm::dvec3(1), waveField);
  for (const Projection projection : {Projection::Orthographic, Projection::Perspective}) {
    for (const glm::dvec3& direction :
         {glm::dvec3(0, 0, 1), glm::dvec3(0, -1, 0), glm::dvec3(1, 1, 0), glm::dvec3(1, 1, 1), glm::dvec3(1, 0, -1)}) {
      Camera camera;
      camera.projection = projection;
      camera.eye = 5.0 * direction;
      camera.center = glm::dvec3(0);
      camera.up = direction.x == 0 ? glm::dvec3(1, 0, 0) : glm::dvec3(1, -1, 0);
      if (direction.y == 0 && direction.x != 0) camera.up = {0, 1, 0};
      camera.heightWorld = 65.0 / 32.0;  // 32 pixels per unit: every fourth centre is in a plane of the grid
      camera.fovyDegrees = 30;
      // On the outline a ray is inside or outside by convention, so the middle is compared.
      const ImageSize size{65, 65};
      const Image image = projectedImage(context(), mesh, camera, kMarch, "", size);
      Camera beside = camera;  // by a thousandth of a pixel
      const glm::dvec3 shift = glm::transpose(camera.viewRotation()) * glm::dvec3(3e-5, 2e-5, 0);
      beside.eye += shift;
      beside.center += shift;
      const Image near = projectedImage(context(), mesh, beside, kMarch, "", size);
      expectFinite(image);
      for (std::uint32_t y = 16; y < 49; y++) {
        for (std::uint32_t x = 16; x < 49; x++)
          EXPECT_NEAR(image.at(x, y).w, near.at(x, y).w, 3e-3)
              << x << " " << y << ", from " << direction.x << " " << direction.y << " " << direction.z;
      }
    }
  }
}

TEST_F(GpuTest, MarchStartsAtTheEyeWhereverItIs) {
  const TetMesh mesh = kuhnGrid(4, 4, 4, glm::dvec3(0), glm::dvec3(1), waveField);
  // In a cell, on a vertex, an edge, a face, the boundary, just inside and just outside of it.
  for (const glm::dvec3& eye :
       {glm::dvec3(0.3, 0.31, 0.33), glm::dvec3(0.5, 0.5, 0.5), glm::dvec3(0.5, 0.5, 0.4), glm::dvec3(0.4, 0.3, 0.5),
        glm::dvec3(0.4, 0.0, 0.6), glm::dvec3(0.4, 1e-6, 0.6), glm::dvec3(0.4, -1e-6, 0.6)}) {
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
      Camera camera;
      camera.projection = projection;
      camera.eye = eye;
      camera.center = {0.51, 0.57, 0.49};
      camera.fovyDegrees = 100;
      camera.heightWorld = 1.4;
      const ImageDifference d = projectionError(context(), mesh, camera, kMarch);
      EXPECT_LE(d.rmse, 5e-5) << eye.x << " " << eye.y << " " << eye.z;
      EXPECT_LE(d.max, 1.0 / 255.0) << eye.x << " " << eye.y << " " << eye.z;
    }
  }
}

TEST_F(GpuTest, MarchByAddressGivesTheSameBits) {
  const TetMesh mesh = randomDelaunay(1500, 7);
  for (const Camera& camera : test::orderViews(mesh)) {
    EXPECT_EQ(projectedImage(context(), mesh, camera, withProjection(CellProjection::March, true)).pixels,
              projectedImage(context(), mesh, camera, kMarch).pixels);
  }
}

TEST_F(GpuTest, MarchIsTheSameEveryTimeAndInEveryTarget) {
  const TetMesh mesh = twistedDelaunay(800, 1, 0.5);  // with overlaps
  const Camera camera = test::orderViews(mesh)[1];
  Renderer renderer(context(), mesh, scalarField(mesh, "", "test"), kMarch);
  renderer.setTransferFunction(test::orderTransfer());
  renderer.draw(camera, {80, 60});
  const Image first = renderer.readImage();
  renderer.draw(test::orderViews(mesh)[0], {30, 40});
  renderer.draw(camera, {80, 60});
  EXPECT_EQ(renderer.readImage().pixels, first.pixels);
  RenderOptions half;
  half.target = Target::Rgba16f;
  half.timed = true;
  const FrameStats stats = renderer.draw(camera, {80, 60}, half);
  EXPECT_LE(compareImages(first, renderer.readImage()).max, std::exp2(-10.0));
  ASSERT_EQ(stats.passes.size(), 2u);
  EXPECT_EQ(stats.passes[0].name, "enter");
  EXPECT_EQ(stats.passes[1].name, "march");
}

// Each of equal cells counts; faces of more than two cells end the walk, and another one begins there.
TEST_F(GpuTest, MarchDrawsEqualCellsAndOverusedFaces) {
  TetMesh mesh;
  mesh.points = std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, -1, 0.5}};
  mesh.pointArrays.push_back({"s", 1, std::vector<float>{0.1f, 0.9f, 0.5f, 0.25f, 0.75f, 0.3f}});
  const std::vector<std::vector<CellVertices>> cases = {{{0, 1, 2, 3}, {0, 1, 2, 3}},
                                                        {{0, 1, 2, 3}, {1, 0, 2, 3}, {3, 1, 2, 0}},
                                                        {{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3, 4}}};
  for (size_t i = 0; i < cases.size(); i++) {
    mesh.cells = cases[i];
    for (const Camera& camera : test::orderViews(mesh))
      EXPECT_LE(projectionError(context(), mesh, camera, kMarch).rmse, 2e-3) << i << ": only the order of equal depths";
  }
}

TEST_F(GpuTest, MarchEndsOnMeshesThatOverlap) {
  TetMesh tangle = randomDelaunay(300, 5);
  auto& points = std::get<std::vector<glm::dvec3>>(tangle.points);
  for (size_t i = 0; i < points.size(); i++) points[i] = points[(i * 17 + 5) % points.size()];
  TetMesh odd;
  odd.points =
      std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}};
  odd.cells = {{0, 1, 2, 3}, {1, 0, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 4},
               {0, 0, 1, 2}, {5, 5, 5, 5}, {0, 5, 6, 1}, {1, 2, 3, 5}};
  odd.pointArrays.push_back({"s", 1, std::vector<float>{0, 1, 0.5f, 0.25f, 0.75f, 0.1f, 0.9f}});
  TetMesh flat = kuhnGrid(4, 4, 4, glm::dvec3(0), glm::dvec3(1), waveField);
  for (glm::dvec3& p : std::get<std::vector<glm::dvec3>>(flat.points)) p.z = 0.25 * p.x;
  for (const TetMesh& mesh : {tangle, odd, flat, twistedDelaunay(800, 1, 2.0)}) {
    for (const Camera& camera : test::orderViews(mesh)) expectFinite(projectedImage(context(), mesh, camera, kMarch));
  }
}

// Folded cells are a small part of a twisted column: all of them count, and most pixels do not see the order.
TEST_F(GpuTest, MarchDrawsEveryLayerOfAFold) {
  const TetMesh mesh = twistedDelaunay(1000, 1, 0.5);
  for (const Camera& camera : test::orderViews(mesh)) {
    const ImageDifference d = projectionError(context(), mesh, camera, kMarch);
    EXPECT_LE(d.rmse, 5e-3) << d.max << " " << d.p99;
  }
}

// A ray through more cells than one dispatch walks: a column of thin layers, seen along it.
TEST_F(GpuTest, MarchGoesOnAfterManyCells) {
  const TetMesh mesh = kuhnGrid(1, 1, 20000, glm::dvec3(0), glm::dvec3(1), [](const glm::dvec3&) { return 0.05; });
  Camera camera;
  camera.eye = {0.43, 0.47, -2};
  camera.center = {0.43, 0.47, 0};
  camera.up = {0, 1, 0};
  for (const double z : {-2.0, 0.75}) {  // the second from within, backwards over most of it
    camera.eye.z = z;
    camera.center.z = z < 0 ? 0 : -1;
    camera.projection = Projection::Orthographic;
    camera.heightWorld = 0.5;
    const ImageDifference d = projectionError(context(), mesh, camera, kMarch, "", {16, 12});
    EXPECT_LE(d.max, 1e-4);
  }
}

TEST_F(GpuTest, MarchOfALargePictureIsDoneInBands) {
  const TetMesh mesh = kuhnGrid(2, 2, 2, glm::dvec3(0), glm::dvec3(1), waveField);
  const Camera camera = test::orderViews(mesh)[0];
  const ImageDifference d = projectionError(context(), mesh, camera, kMarch, "", {1400, 1100});
  EXPECT_LE(d.rmse, 5e-5);
  EXPECT_LE(d.max, 1.0 / 255.0);
}

}  // namespace
}  // namespace tetralux::render
