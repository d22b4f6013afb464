// Order "auto": no more than the view needs; and "kbuffer", which knows where it was wrong.
#include "gpu_fixture.h"
#include "image/metrics.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "support/tilted.h"

namespace tetralux::render {
namespace {

using test::exactImage;
using test::OrderedRenderer;
using test::orderTransfer;
using test::orderViews;
using test::reportOf;
using test::tilted;

using AutoOrderTest = test::GpuTest;

double rmseOf(OrderedRenderer& renderer, const TetMesh& mesh, const Camera& camera) {
  return compareImages(exactImage(mesh, orderTransfer(), camera), renderer.readImage()).rmse;
}

TEST_F(AutoOrderTest, TakesCentroidsExactlyWhereTheyAreRight) {
  const TetMesh mesh = kuhnGrid(4, 4, 4, glm::dvec3(0), glm::dvec3(1), waveField);
  OrderedRenderer radix(context(), mesh, Order::Radix);
  OrderedRenderer renderer(context(), mesh, Order::Auto);
  int taken = 0;
  for (int i = 0; i < 24; i++) {
    Camera camera = orderViews(mesh)[0].turned(15.0 * i);
    camera.eye = camera.center + (1.0 + i % 4) * (camera.eye - camera.center);
    camera.fovyDegrees = 30.0 / (1.0 + i % 4);
    const bool isRight = radix.draw(camera).order.isExact();
    EXPECT_EQ(renderer.draw(camera).order.order == Order::Radix, isRight);
    taken += isRight;
  }
  EXPECT_GT(taken, 0);
}

TEST_F(AutoOrderTest, IsExactWhateverTheMesh) {
  for (const TetMesh& mesh : {tilted(randomDelaunay(1000, 1)), twistedDelaunay(1000, 1, 0.25), sliverChain(20, 0.5),
                              tilted(gradedBox(6, 100)), cyclicOctahedron()}) {
    OrderedRenderer renderer(context(), mesh, Order::Auto);
    for (const Camera& camera : orderViews(mesh)) {
      const OrderReport report = renderer.draw(camera).order;
      EXPECT_TRUE(report.isExact());
      EXPECT_LE(rmseOf(renderer, mesh, camera), 5e-5);
    }
  }
}

// Auto needs its check even when nobody asks for counts.
TEST_F(AutoOrderTest, ChecksWithoutBeingAsked) {
  const TetMesh mesh = tilted(randomDelaunay(1000, 1));
  Renderer renderer(context(), mesh, scalarField(mesh, "", "test"));
  renderer.setTransferFunction(orderTransfer());
  const OrderReport report = renderer.draw(orderViews(mesh)[0], test::kOrderSize).order;
  EXPECT_NE(report.order, Order::Radix);
}

TEST_F(AutoOrderTest, KBufferCountsThePixelsWhereItIsTooSmall) {
  const TetMesh mesh = tilted(randomDelaunay(1500, 3));
  const Camera camera = orderViews(mesh)[0];
  std::uint64_t shortPixels = ~std::uint64_t{0};
  double error = 1.0;
  for (const std::uint32_t k : {1u, 2u, 6u, 16u}) {
    RendererOptions options;
    options.kBuffer = k;
    OrderedRenderer renderer(context(), mesh, Order::KBuffer, options);
    const OrderReport report = renderer.draw(camera).order;
    const double rmse = rmseOf(renderer, mesh, camera);
    EXPECT_GT(report.misordered, 0u) << "the sort alone is wrong";
    EXPECT_LE(report.shortPixels, shortPixels);
    EXPECT_LE(rmse, error * 1.01);
    EXPECT_EQ(report.isExact(), report.shortPixels == 0);
    if (report.isExact()) {
      EXPECT_LE(rmse, 5e-5);
    }
    if (k == 1) {
      EXPECT_GT(report.shortPixels, 100u);
    }
    shortPixels = report.shortPixels;
    error = rmse;
  }
  EXPECT_EQ(shortPixels, 0u) << "16 are enough here";
}

// Drawn in several batches' and bands' worth of lists: more fragments than they have room for at first.
TEST_F(AutoOrderTest, KBufferOfManyLayers) {
  const TetMesh mesh = kuhnGrid(3, 3, 120, glm::dvec3(0), glm::dvec3(1), waveField);
  Camera camera;
  camera.center = glm::dvec3(0.5);
  camera.eye = {0.62, 0.41, -1.5};
  camera.up = {0, 1, 0};
  camera.fovyDegrees = 30;
  RendererOptions options;
  options.order = Order::KBuffer;
  Renderer renderer(context(), mesh, scalarField(mesh, "", "test"), options);
  renderer.setTransferFunction(orderTransfer());
  const Image first = (renderer.draw(camera, {200, 150}), renderer.readImage());
  const OrderReport report = renderer.draw(camera, {200, 150}).order;
  EXPECT_EQ(renderer.readImage().pixels, first.pixels);
  options.order = Order::Exact;
  Renderer exact(context(), mesh, scalarField(mesh, "", "test"), options);
  exact.setTransferFunction(orderTransfer());
  exact.draw(camera, {200, 150});
  if (report.isExact()) {
    EXPECT_LE(compareImages(exact.readImage(), first).max, 1e-5);
  }
}

}  // namespace
}  // namespace tetralux::render
