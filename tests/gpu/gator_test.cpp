// Cells projected by the vertex shader: the same pictures as by the project pass, without its buffers. What all
// projections have to draw: projection_test.cpp.
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

// One function projects for both; compilers may contract its products differently in a vertex shader, so the last
// digits of a position may differ, and with them which pixels of an edge are covered.
TEST_F(GpuTest, GatorDrawsWhatThePassProjects) {
  const TetMesh mesh = randomDelaunay(1500, 7);
  for (const Camera& camera : test::orderViews(mesh)) {
    const Image fans = projectedImage(context(), mesh, camera, withProjection(CellProjection::Pt));
    const ImageDifference d = compareImages(fans, projectedImage(context(), mesh, camera, kGator));
    EXPECT_LE(d.rmse, 1e-5);
    EXPECT_LE(d.max, 1e-3);
  }
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
