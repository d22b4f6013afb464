// Whole frames of both emissions, and of scaled extinctions, against the double-precision picture.
#include <cmath>

#include "base/error.h"
#include "gpu_fixture.h"
#include "image/metrics.h"
#include "mesh/generate.h"
#include "reference/ray_caster.h"
#include "render/renderer.h"
#include "support/expect_error.h"

namespace tetralux::render {
namespace {

using test::GpuTest;

constexpr ImageSize kSize{96, 72};

TransferFunction bands(Emission emission) {
  return TransferFunction({{0, {0.1, 0.1, 0.8}, 0.1},
                           {0.3, {0.1, 0.7, 0.2}, 2},
                           {0.5, {0.9, 0.8, 0.1}, 0},
                           {0.7, {0.9, 0.3, 0.1}, 6},
                           {1, {0.8, 0.1, 0.3}, 1}},
                          "bands", emission);
}

std::vector<Camera> cameras() {
  std::vector<Camera> result(3);
  result[0].eye = {2.1, -1.7, 1.3};
  result[1].eye = {0.4, 0.3, 0.6};  // inside
  result[2].eye = {2.1, -1.7, 1.3};
  result[2].projection = Projection::Orthographic;
  result[2].heightWorld = 2.2;
  for (Camera& camera : result) {
    camera.center = {0.52, 0.47, 0.51};
    camera.fovyDegrees = 50;
  }
  return result;
}

struct Pair {
  Image exact;
  Image drawn;
  FrameStats stats;
};

Pair drawBoth(const gpu::Context& context, const TetMesh& mesh, const TransferFunction& transfer, const Camera& camera,
              Order order = Order::Auto, CellProjection projection = CellProjection::Pt) {
  const ScalarField field = scalarField(mesh, "", "test");
  RendererOptions options;
  options.order = order;
  options.projection = projection;
  Renderer renderer(context, mesh, field, options);
  renderer.setTransferFunction(transfer);
  Pair result;
  result.stats = renderer.draw(camera, kSize);
  result.drawn = renderer.readImage();
  result.exact = reference::toImage(reference::renderPixels({mesh, field, transfer, camera, kSize}), kSize);
  return result;
}

TEST_F(GpuTest, BothEmissionsAgreeWithTheReference) {
  const TetMesh meshes[] = {jitteredGrid(6, 5, 4, glm::dvec3(0), glm::dvec3(1), 0.15, 3, waveField),
                            randomDelaunay(1500, 6)};
  for (const TetMesh& mesh : meshes) {
    for (const Emission emission : {Emission::PerExtinction, Emission::PerLength}) {
      for (const Camera& camera : cameras()) {
        const Pair pair = drawBoth(context(), mesh, bands(emission), camera);
        const ImageDifference d = compareImages(pair.exact, pair.drawn);
        EXPECT_LE(d.rmse, 5e-5) << mesh.cellCount() << " cells, emission " << static_cast<int>(emission);
        EXPECT_EQ(d.nonFinite, 0u);
      }
    }
  }
}

// Lists per pixel integrate with a shader of their own.
TEST_F(GpuTest, EmissionPerLengthIsTheSameThroughAKBuffer) {
  const TetMesh mesh = randomDelaunay(800, 9);
  const Pair pair = drawBoth(context(), mesh, bands(Emission::PerLength), cameras()[0], Order::KBuffer);
  EXPECT_LE(compareImages(pair.exact, pair.drawn).rmse, 5e-5);
}

// Outlines and rays that walk have code of their own for what lies in front; dark parts must not hide what glows
// behind.
TEST_F(GpuTest, EmissionPerLengthByEveryProjection) {
  const TetMesh mesh = randomDelaunay(1500, 6);
  const TransferFunction dense = bands(Emission::PerLength).scaled(10);
  for (const CellProjection projection : {CellProjection::Silhouette, CellProjection::March}) {
    for (const Camera& camera : cameras()) {
      for (const TransferFunction& transfer : {bands(Emission::PerLength), dense}) {
        const Pair pair = drawBoth(context(), mesh, transfer, camera, Order::Auto, projection);
        EXPECT_LE(compareImages(pair.exact, pair.drawn).rmse, 5e-5) << projectionName(projection);
      }
    }
  }
}

TEST_F(GpuTest, MethodsThatCannotCarryEmissionPerLengthRefuse) {
  const TetMesh mesh = kuhnGrid(2, 2, 2, glm::dvec3(0), glm::dvec3(1), waveField);
  Renderer renderer(context(), mesh, scalarField(mesh, "", "test"));
  for (const std::string& name : integrationNames()) {
    RenderOptions options;
    options.integration = parseIntegration(name);
    renderer.setTransferFunction(bands(Emission::PerExtinction));
    EXPECT_NO_THROW(renderer.draw(cameras()[0], kSize, options)) << name;
    renderer.setTransferFunction(bands(Emission::PerLength));
    if (name != "moments" && name != "ppi") {
      EXPECT_NO_THROW(renderer.draw(cameras()[0], kSize, options)) << name;
      continue;
    }
    EXPECT_EQ(
        test::errorOf(ErrorCode::Usage, [&] { renderer.draw(cameras()[0], kSize, options); }),
        "--integration: found '" + name + "' with emission per length, expected a method other than moments and ppi");
  }
}

TEST_F(GpuTest, CellsThatOnlyEmitAreDrawn) {
  const TetMesh mesh = jitteredGrid(5, 5, 5, glm::dvec3(0), glm::dvec3(1), 0.1, 2, waveField);
  const std::vector<ControlPoint> points = {{0, {}, 0}, {0.5, {0, 0.5, 1}, 0}, {1, {}, 0}};
  const Pair glow = drawBoth(context(), mesh, TransferFunction(points, "t", Emission::PerLength), cameras()[0]);
  EXPECT_GT(glow.stats.drawnCells, 0u);
  EXPECT_LE(compareImages(glow.exact, glow.drawn).rmse, 5e-5);
  double light = 0.0;
  for (const glm::vec4& p : glow.drawn.pixels) {
    EXPECT_EQ(p.w, 0.0f);
    light += static_cast<double>(p.z);
  }
  EXPECT_GT(light, 100.0);
  const Pair dark = drawBoth(context(), mesh, TransferFunction(points, "t"), cameras()[0]);
  EXPECT_EQ(dark.stats.drawnCells, 0u);
}

TEST_F(GpuTest, CellsThatNeitherEmitNorAbsorbAreCulled) {
  const TetMesh mesh = kuhnGrid(4, 4, 4, glm::dvec3(0), glm::dvec3(1), [](const glm::dvec3& p) { return p.x; });
  const std::vector<ControlPoint> points = {{0, {}, 0}, {0.5, {}, 0}, {0.75, {1, 1, 1}, 0}, {1, {}, 0}};
  const Pair pair = drawBoth(context(), mesh, TransferFunction(points, "t", Emission::PerLength), cameras()[0]);
  EXPECT_EQ(pair.stats.drawnCells, mesh.cellCount() / 2);
  EXPECT_EQ(pair.stats.culledTransparent, mesh.cellCount() / 2);
}

// Emission per length that is luminance times extinction is emission per extinction, where both are linear.
TEST_F(GpuTest, EmissionsAgreeWhereTheyMeanTheSame) {
  const TetMesh mesh = randomDelaunay(800, 4);
  const Image a =
      drawBoth(context(), mesh, TransferFunction({{0, {0.5, 1, 0.25}, 1}, {1, {0.5, 1, 0.25}, 5}}, "t"), cameras()[0])
          .drawn;
  const TransferFunction same({{0, {0.5, 1, 0.25}, 1}, {1, {2.5, 5, 1.25}, 5}}, "t", Emission::PerLength);
  EXPECT_LE(compareImages(a, drawBoth(context(), mesh, same, cameras()[0]).drawn).max, 2e-5);
}

TEST_F(GpuTest, UnitsOfTheMeshDoNotShowInEmissionPerLength) {
  const auto draw = [&](double scale) {
    const TetMesh mesh =
        kuhnGrid(5, 5, 5, glm::dvec3(0), glm::dvec3(scale), [&](const glm::dvec3& p) { return waveField(p / scale); });
    std::vector<ControlPoint> points = bands(Emission::PerLength).points();
    for (ControlPoint& p : points) {
      p.tau /= scale;
      p.rgb /= scale;
    }
    Camera camera = cameras()[0];
    camera.eye *= scale;
    camera.center *= scale;
    return drawBoth(context(), mesh, TransferFunction(points, "t", Emission::PerLength), camera).drawn;
  };
  const Image plain = draw(1);
  EXPECT_LE(compareImages(plain, draw(1e-9)).max, 1e-3);
  EXPECT_LE(compareImages(plain, draw(1e9)).max, 1e-3);
}

TEST_F(GpuTest, ScaledOpacityIsScaledExtinction) {
  const TetMesh mesh = jitteredGrid(5, 4, 4, glm::dvec3(0), glm::dvec3(1), 0.1, 7, waveField);
  for (const Emission emission : {Emission::PerExtinction, Emission::PerLength}) {
    std::vector<ControlPoint> points = bands(emission).points();
    for (ControlPoint& p : points) p.tau *= 2.5;
    const Pair scaled = drawBoth(context(), mesh, bands(emission).scaled(2.5), cameras()[0]);
    EXPECT_EQ(scaled.drawn.pixels,
              drawBoth(context(), mesh, TransferFunction(points, "t", emission), cameras()[0]).drawn.pixels);
    EXPECT_LE(compareImages(scaled.exact, scaled.drawn).rmse, 5e-5);
    EXPECT_GT(compareImages(scaled.drawn, drawBoth(context(), mesh, bands(emission), cameras()[0]).drawn).rmse, 1e-2);
  }
}

}  // namespace
}  // namespace tetralux::render
