// Fans whose vertices are snapped to the rasteriser's grid, as every device but Mesa's software one does it: what is
// interpolated over them is still right. Left alone, the errors of these pictures are those in the comments.
#include <gtest/gtest.h>

#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"
#include "reference/ray_caster.h"

namespace tetralux::render {
namespace {

class SnappedVertices : public test::GpuTest, public testing::WithParamInterface<CellProjection> {
 protected:
  RendererOptions options() const {
    RendererOptions options = test::withProjection(GetParam());
    options.snapVertices = true;
    return options;
  }
};

// RMSE 1.2e-5 to 4.0e-5.
TEST_P(SnappedVertices, DrawEveryView) {
  TetMesh mesh = kuhnGrid(6, 5, 4, glm::dvec3(0), glm::dvec3(1), waveField);
  for (const Camera& camera : test::orderViews(mesh)) {
    const ImageDifference d = test::projectionError(context(), mesh, camera, options());
    EXPECT_LE(d.rmse, 2e-6);
    EXPECT_EQ(d.nonFinite, 0u);
  }
}

// Peaks of 1e-4 of the range turn a scalar that is a little off into no light: RMSE 5.1e-4.
TEST_P(SnappedVertices, DrawNarrowPeaks) {
  std::vector<ControlPoint> points;
  for (const double s : {0.2, 0.4, 0.6, 0.8}) {
    points.push_back({s - 5e-5, {0.9, s, 0.1}, 0.0});
    points.push_back({s, {0.9, s, 0.1}, 3e4});
    points.push_back({s + 5e-5, {0.9, s, 0.1}, 0.0});
  }
  const TransferFunction peaks(points, "peaks");
  const TetMesh mesh = randomDelaunay(800, 1, [](const glm::dvec3& p) { return p.x; });
  const ScalarField field = scalarField(mesh, "", "test");
  const Camera camera = test::orderViews(mesh)[0];
  Renderer renderer(context(), mesh, field, options());
  renderer.setTransferFunction(peaks);
  renderer.draw(camera, test::kProjectionSize);
  const Image exact = reference::toImage(reference::renderPixels({mesh, field, peaks, camera, test::kProjectionSize}),
                                         test::kProjectionSize);
  EXPECT_LE(compareImages(exact, renderer.readImage()).rmse, 5e-5);
}

INSTANTIATE_TEST_SUITE_P(Fans, SnappedVertices, testing::Values(CellProjection::Pt, CellProjection::Gator),
                         [](const auto& projection) { return projectionName(projection.param); });

}  // namespace
}  // namespace tetralux::render
