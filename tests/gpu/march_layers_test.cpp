// Rays through layers that overlap, in single and in double precision, and pictures of more than one band.
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

RendererOptions walking(bool isDouble) {
  RendererOptions options = test::withProjection(CellProjection::March);
  options.doublePrecision = isDouble;
  return options;
}

TEST_F(GpuTest, RaysCompositeOverlappingLayersByTheirSegmentsMiddles) {
  // Columns so twisted that cells are turned over.
  for (const double turns : {0.5, 0.7, 1.5}) {
    const TetMesh mesh = twistedDelaunay(800, 1, turns);
    for (const Camera& camera : test::orderViews(mesh)) {
      for (const bool isDouble : {false, true}) {
        if (isDouble && !context().info().hasFloat64) continue;
        const ImageDifference d = projectionError(context(), mesh, camera, walking(isDouble));
        EXPECT_LE(d.rmse, 5e-6) << turns;
        EXPECT_LE(d.max, 1.0 / 510.0) << turns;
      }
    }
  }
}

TEST_F(GpuTest, DoublePrecisionIsCloserWhereAMediumIsDense) {
  if (!context().info().hasFloat64) GTEST_SKIP() << "the device has no double precision";
  const TetMesh mesh = flattenedDelaunay(300, 3, 1e-6);
  const ScalarField field = scalarField(mesh, "", "test");
  const TransferFunction dense({{field.low, {1, 0.2, 0}, 1e6}, {field.high, {0, 0.3, 1}, 4e6}}, "dense");
  Camera camera = test::orderViews(mesh)[0];
  const Image exact = test::exactImage(mesh, dense, camera);
  double error[2];
  for (const bool isDouble : {false, true}) {
    Renderer renderer(context(), mesh, field, walking(isDouble));
    renderer.setTransferFunction(dense);
    EXPECT_EQ(renderer.draw(camera, test::kOrderSize).doublePrecision, isDouble);
    error[isDouble] = compareImages(exact, renderer.readImage()).max;
  }
  EXPECT_LE(error[1], 1e-5);
  EXPECT_GT(error[0], 10.0 * error[1]);
  // By itself it is chosen here, and not for an ordinary picture.
  Renderer renderer(context(), mesh, field, test::withProjection(CellProjection::March));
  renderer.setTransferFunction(dense);
  EXPECT_TRUE(renderer.draw(camera, test::kOrderSize).doublePrecision);
  renderer.setTransferFunction(test::orderTransfer());
  EXPECT_FALSE(renderer.draw(camera, test::kOrderSize).doublePrecision);
}

// A band holds a million pixels.
TEST_F(GpuTest, BandsJoinWithoutASeam) {
  const TetMesh mesh = kuhnGrid(2, 2, 2, glm::dvec3(-1), glm::dvec3(1), waveField);
  const ImageDifference d =
      projectionError(context(), mesh, test::orderViews(mesh)[0], walking(false), "", ImageSize{1100, 1100});
  EXPECT_LE(d.max, 1e-4);
}

}  // namespace
}  // namespace tetralux::render
