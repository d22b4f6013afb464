// Cells drawn as outlines, against fans; their pictures: projection_test.cpp.
#include <gtest/gtest.h>

#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"

namespace tetralux::render {
namespace {

using test::GpuTest;
using test::withProjection;

TEST_F(GpuTest, SilhouettesAreFewerTriangles) {
  const TetMesh mesh = randomDelaunay(1500, 7);
  const Camera camera = test::orderViews(mesh)[0];
  std::uint64_t triangles[2];
  for (const CellProjection projection : {CellProjection::Pt, CellProjection::Silhouette}) {
    Renderer renderer(context(), mesh, scalarField(mesh, "", "test"), withProjection(projection));
    renderer.setTransferFunction(test::orderTransfer());
    const FrameStats stats = renderer.draw(camera, test::kProjectionSize);
    triangles[projection == CellProjection::Pt ? 0 : 1] = stats.triangles;
    EXPECT_LE(stats.triangles, (projection == CellProjection::Pt ? 4 : 2) * stats.drawnCells);
  }
  EXPECT_LT(triangles[1], 0.6 * static_cast<double>(triangles[0]));
}

// Cells smaller than pixels: one triangle each, whatever their outline, and the same picture.
TEST_F(GpuTest, SilhouettesOfTinyCellsAreTheirPixels) {
  const TetMesh mesh = randomDelaunay(6000, 7);
  const ScalarField field = scalarField(mesh, "", "test");
  constexpr ImageSize kTiny{14, 10};
  std::uint64_t triangles = 0;
  std::uint64_t cells = 0;
  for (const Camera& camera : test::orderViews(mesh)) {
    Renderer renderer(context(), mesh, field, withProjection(CellProjection::Silhouette));
    renderer.setTransferFunction(test::orderTransfer());
    const FrameStats stats = renderer.draw(camera, kTiny);
    EXPECT_GE(stats.triangles, stats.drawnCells);
    triangles += stats.triangles;
    cells += stats.drawnCells;
    const ImageDifference d =
        test::projectionError(context(), mesh, camera, withProjection(CellProjection::Silhouette), "", kTiny);
    EXPECT_LE(d.rmse, 5e-5);
    EXPECT_LE(d.max, 1.0 / 255.0);
  }
  EXPECT_LT(triangles, 1.3 * static_cast<double>(cells));
}

}  // namespace
}  // namespace tetralux::render
