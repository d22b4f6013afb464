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

}  // namespace
}  // namespace tetralux::render
