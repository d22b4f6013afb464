// Cells projected by the vertex shader: the same pictures as by the project pass, without its buffers.
#include <gtest/gtest.h>

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

const RendererOptions kGator = withProjection(CellProjection::Gator);

TEST_F(GpuTest, GatorAgreesWithTheReferenceOnHardMeshes) {
  for (const auto& [name, mesh] : test::hardMeshes()) {
    const std::vector<Camera> views = test::orderViews(mesh);
    for (size_t view = 0; view < views.size(); view++) {
      const ImageDifference d = projectionError(context(), mesh, views[view], kGator);
      EXPECT_LE(d.rmse, 5e-5) << name << ", view " << view;
      EXPECT_LE(d.max, 1.0 / 255.0) << name << ", view " << view;
      EXPECT_EQ(d.nonFinite, 0u);
    }
  }
}

// One function projects for both; compilers may contract its products differently in a vertex shader, so the last digits of
// a position may differ, and with them which pixels of an edge are covered.
TEST_F(GpuTest, GatorDrawsWhatThePassProjects) {
  const TetMesh mesh = randomDelaunay(1500, 7);
  for (const Camera& camera : test::orderViews(mesh)) {
    const Image fans = projectedImage(context(), mesh, camera, withProjection(CellProjection::Pt));
    const ImageDifference d = compareImages(fans, projectedImage(context(), mesh, camera, kGator));
    EXPECT_LE(d.rmse, 1e-5);
    EXPECT_LE(d.max, 1e-3);
  }
}

TEST_F(GpuTest, GatorOfCellFieldsAndByAddress) {
  TetMesh mesh = kuhnGrid(4, 4, 4, glm::dvec3(0), glm::dvec3(1), waveField);
  std::vector<float> values;
  for (size_t i = 0; i < mesh.cellCount(); i++) values.push_back(static_cast<float>(i * 7919 % 100) / 99.0f);
  mesh.cellArrays.push_back({"c", 1, values});
  for (const Camera& camera : test::orderViews(mesh)) {
    EXPECT_LE(projectionError(context(), mesh, camera, kGator, "c").rmse, 5e-5);
    EXPECT_EQ(projectedImage(context(), mesh, camera, withProjection(CellProjection::Gator, true), "c").pixels,
              projectedImage(context(), mesh, camera, kGator, "c").pixels);
  }
}

// Cycles go through the lists of the apart pass, several batches through several draws.
TEST_F(GpuTest, GatorOfACycleIsCompositedApart) {
  const TetMesh mesh = cyclicOctahedron();
  Camera camera;
  camera.eye = {0.02, 0.03, -5};
  camera.center = {0, 0, 0.5};
  camera.up = {0, 1, 0};
  camera.fovyDegrees = 30;
  EXPECT_LE(projectionError(context(), mesh, camera, kGator).rmse, 5e-5);
}

TEST_F(GpuTest, GatorDrawsBatchAfterBatch) {
  const TetMesh mesh = kuhnGrid(37, 37, 37, glm::dvec3(0), glm::dvec3(1), waveField);
  ASSERT_GT(mesh.cellCount(), shared::BATCH_CELLS);
  const Camera camera = test::orderViews(mesh)[0];
  EXPECT_LE(projectionError(context(), mesh, camera, kGator).rmse, 5e-5);
}

TEST_F(GpuTest, GatorWithEveryMethodAndInterpolationDrawsAsPt) {
  const TetMesh mesh = randomDelaunay(400, 7);
  const Camera camera = test::orderViews(mesh)[0];
  Image images[2];
  for (const std::string& method : integrationNames()) {
    for (const Interpolation interpolation : {Interpolation::Perspective, Interpolation::Screen}) {
      for (const CellProjection projection : {CellProjection::Pt, CellProjection::Gator}) {
        Renderer renderer(context(), mesh, scalarField(mesh, "", "test"), withProjection(projection));
        renderer.setTransferFunction(test::orderTransfer());
        RenderOptions options;
        options.integration = parseIntegration(method);
        options.interpolation = interpolation;
        renderer.draw(camera, test::kProjectionSize, options);
        images[projection == CellProjection::Pt ? 0 : 1] = renderer.readImage();
      }
      EXPECT_LE(compareImages(images[0], images[1]).rmse, 2e-5) << method;
    }
  }
}

// A batch of the others is 124 bytes of projected cells more.
TEST_F(GpuTest, GatorKeepsNoProjectedCells) {
  const TetMesh mesh = randomDelaunay(1500, 7);
  std::uint64_t bytes[2];
  for (const CellProjection projection : {CellProjection::Pt, CellProjection::Gator}) {
    Renderer renderer(context(), mesh, scalarField(mesh, "", "test"), withProjection(projection));
    renderer.setTransferFunction(test::orderTransfer());
    const FrameStats stats = renderer.draw(test::orderViews(mesh)[0], test::kProjectionSize);
    EXPECT_EQ(stats.clippedCells.has_value(), projection == CellProjection::Pt);
    bytes[projection == CellProjection::Pt ? 0 : 1] = renderer.memoryUse().frameBytes;
  }
  EXPECT_EQ(bytes[0] - bytes[1], mesh.cellCount() * (5 * 24 + 4));
}

}  // namespace
}  // namespace tetralux::render
