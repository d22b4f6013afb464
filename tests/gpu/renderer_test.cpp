// Whole frames against closed forms and against each other.
#include "render/renderer.h"

#include <cmath>

#include "gpu_fixture.h"
#include "image/metrics.h"
#include "mesh/generate.h"
#include "reference/ray_caster.h"

namespace tetralux::render {
namespace {

using test::GpuTest;

const TransferFunction& uniform() {
  static const TransferFunction transfer({{0, {0.5, 1, 0.25}, 1.5}}, "uniform");
  return transfer;
}

const TransferFunction& bands() {
  static const TransferFunction transfer({{0, {0.1, 0.1, 0.8}, 0.1},
                                          {0.3, {0.1, 0.7, 0.2}, 2},
                                          {0.5, {0.9, 0.8, 0.1}, 0},
                                          {0.7, {0.9, 0.3, 0.1}, 6},
                                          {1, {0.8, 0.1, 0.3}, 1}},
                                         "bands");
  return transfer;
}

std::vector<Camera> cameras() {
  std::vector<Camera> result(4);
  result[0].eye = {2.1, -1.7, 1.3};
  result[1].eye = {0.4, 0.3, 0.6};  // inside
  result[2].eye = {2.1, -1.7, 1.3};
  result[2].projection = Projection::Orthographic;
  result[2].heightWorld = 2.2;
  result[3].eye = {0.7, 0.2, 0.5};  // the eye's plane cuts the mesh
  result[3].projection = Projection::Orthographic;
  result[3].heightWorld = 1.5;
  for (Camera& camera : result) {
    camera.center = {0.52, 0.47, 0.51};
    camera.fovyDegrees = 50;
  }
  return result;
}

double chord(const Ray& ray) {
  double front = 0.0;
  double back = 1e300;
  for (int axis = 0; axis < 3; axis++) {
    const double a = (0.0 - ray.origin[axis]) / ray.direction[axis];
    const double b = (1.0 - ray.origin[axis]) / ray.direction[axis];
    front = std::max(front, std::min(a, b));
    back = std::min(back, std::max(a, b));
  }
  return std::max(0.0, back - front) * ray.lengthPerDepth;
}

Image drawOnce(const gpu::Context& context, const TetMesh& mesh, const TransferFunction& transfer, const Camera& camera,
               ImageSize size, const RendererOptions& rendererOptions = {}, const RenderOptions& options = {},
               const std::string& field = "") {
  Renderer renderer(context, mesh, scalarField(mesh, field, "test"), rendererOptions);
  renderer.setTransferFunction(transfer);
  renderer.draw(camera, size, options);
  return renderer.readImage();
}

Image referenceImage(const TetMesh& mesh, const TransferFunction& transfer, const Camera& camera, ImageSize size,
                     const std::string& field = "") {
  return reference::toImage(reference::renderPixels({mesh, scalarField(mesh, field, "test"), transfer, camera, size}),
                            size);
}

TEST_F(GpuTest, UniformBoxIsTheClosedFormFromAnyView) {
  const TetMesh mesh = jitteredGrid(4, 3, 5, glm::dvec3(0), glm::dvec3(1), 0.1, 5, waveField);
  const ImageSize size{61, 47};
  for (const Camera& camera : cameras()) {
    const Image image = drawOnce(context(), mesh, uniform(), camera, size);
    int off = 0;
    for (std::uint32_t y = 0; y < size.height; y++) {
      for (std::uint32_t x = 0; x < size.width; x++) {
        const double alpha = 1.0 - std::exp(-1.5 * chord(camera.pixelRay(size, x, y)));
        // A pixel whose centre lies within the rasteriser's 1/256 pixel of the box's outline may miss it.
        if (std::abs(static_cast<double>(image.at(x, y).w) - alpha) > 1e-4) off++;
        EXPECT_NEAR(image.at(x, y).w, alpha, 2e-2) << x << " " << y;
        EXPECT_NEAR(image.at(x, y).x, 0.5f * image.at(x, y).w, 1e-5);
      }
    }
    EXPECT_LE(off, 3);
  }
}

TEST_F(GpuTest, SplittingACellLeavesTheImageUnchanged) {
  const auto linear = [](const glm::dvec3& p) { return 0.3 * p.x + 0.5 * p.y + 0.2 * p.z; };
  const ImageSize size{50, 50};
  for (const Camera& camera : cameras()) {
    const Image coarse =
        drawOnce(context(), kuhnGrid(1, 1, 1, glm::dvec3(0), glm::dvec3(1), linear), uniform(), camera, size);
    const Image fine = drawOnce(context(), randomDelaunay(3000, 4, linear), uniform(), camera, size);
    const Image exact =
        referenceImage(kuhnGrid(1, 1, 1, glm::dvec3(0), glm::dvec3(1), linear), uniform(), camera, size);
    EXPECT_LE(compareImages(exact, coarse).max, 2e-5);
    EXPECT_LE(compareImages(exact, fine).rmse, 1e-4);
    EXPECT_LE(compareImages(exact, fine).p99, 5e-5) << "forty times as many cells on a ray";
  }
}

TEST_F(GpuTest, FramesAgreeWithTheReference) {
  const ImageSize size{96, 72};
  const TetMesh mesh = kuhnGrid(6, 5, 4, glm::dvec3(0), glm::dvec3(1), waveField);
  for (const Camera& camera : cameras()) {
    const ImageDifference d =
        compareImages(referenceImage(mesh, bands(), camera, size), drawOnce(context(), mesh, bands(), camera, size));
    EXPECT_LE(d.rmse, 5e-4) << "what the order by centroids costs here";
    EXPECT_EQ(d.nonFinite, 0u);
  }
}

TEST_F(GpuTest, CellFieldsAgreeWithTheReference) {
  TetMesh mesh = kuhnGrid(4, 4, 4, glm::dvec3(0), glm::dvec3(1), waveField);
  std::vector<std::int16_t> values;
  for (size_t i = 0; i < mesh.cellCount(); i++) values.push_back(static_cast<std::int16_t>(i * 7919 % 100));
  mesh.cellArrays.push_back({"c", 1, values});
  std::vector<ControlPoint> points = bands().points();
  for (ControlPoint& p : points) p.s *= 100;
  const TransferFunction transfer(points, "t");
  const ImageSize size{64, 64};
  const std::vector<Camera> views = cameras();
  for (const Camera& camera : views) {
    const ImageDifference d = compareImages(referenceImage(mesh, transfer, camera, size, "c"),
                                            drawOnce(context(), mesh, transfer, camera, size, {}, {}, "c"));
    // From inside, the order by centroids is wrong for some cells next to the eye.
    EXPECT_LE(d.rmse, &camera == &views[1] ? 3e-3 : 5e-5);
  }
}

TEST_F(GpuTest, SameInputGivesTheSameBits) {
  const TetMesh mesh = randomDelaunay(2000, 8);
  const Camera camera = cameras()[0];
  const Image first = drawOnce(context(), mesh, bands(), camera, {80, 60});
  for (int i = 0; i < 3; i++) EXPECT_EQ(drawOnce(context(), mesh, bands(), camera, {80, 60}).pixels, first.pixels);
}

TEST_F(GpuTest, EveryCodePathGivesTheSameBits) {
  const TetMesh mesh = randomDelaunay(2000, 8);
  for (const Camera& camera : cameras()) {
    const Image first = drawOnce(context(), mesh, bands(), camera, {80, 60});
    for (const bool wide : {false, true}) {
      for (const SortVariant variant : {SortVariant::Tiles, SortVariant::Chunks}) {
        RendererOptions options;
        options.forceWideAddressing = wide;
        options.sortVariant = variant;
        EXPECT_EQ(drawOnce(context(), mesh, bands(), camera, {80, 60}, options).pixels, first.pixels);
      }
    }
  }
}

TEST_F(GpuTest, TimingAPassDoesNotChangeThePicture) {
  const TetMesh mesh = randomDelaunay(2000, 8);
  RenderOptions timed;
  timed.timed = true;
  const Camera camera = cameras()[0];
  EXPECT_EQ(drawOnce(context(), mesh, bands(), camera, {80, 60}, {}, timed).pixels,
            drawOnce(context(), mesh, bands(), camera, {80, 60}).pixels);
  Renderer renderer(context(), mesh, scalarField(mesh, "", "test"));
  renderer.setTransferFunction(bands());
  FrameStats stats = renderer.draw(camera, {80, 60}, timed);
  renderer.readImage(&stats);
  std::vector<std::string> names;
  double sum = 0.0;
  for (const auto& pass : stats.passes) {
    names.push_back(pass.name);
    sum += pass.gpuMs;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"cull", "check", "order", "sort", "project", "raster"}));
  EXPECT_GT(stats.frameMs, 0.0);
  EXPECT_LE(sum, stats.frameMs * 1.001);
  EXPECT_GT(stats.readbackMs, 0.0);
  EXPECT_EQ(stats.drawnCells + stats.culledOutside + stats.culledNoSample + stats.culledTransparent, mesh.cellCount());
}

TEST_F(GpuTest, HalfFloatTargetIsCloseAndNotWorseThanItsRounding) {
  const TetMesh mesh = kuhnGrid(6, 6, 6, glm::dvec3(0), glm::dvec3(1), waveField);
  RenderOptions half;
  half.target = Target::Rgba16f;
  const Camera camera = cameras()[0];
  const Image a = drawOnce(context(), mesh, bands(), camera, {64, 64});
  const Image b = drawOnce(context(), mesh, bands(), camera, {64, 64}, {}, half);
  EXPECT_LE(compareImages(a, b).max, 40 * std::exp2(-12.0)) << "at most 40 cells behind each other";
  EXPECT_GT(compareImages(a, b).max, 0.0);
}

// Larger than one batch, with a culled part: batches must follow each other back to front.
TEST_F(GpuTest, ManyBatchesMakeOnePicture) {
  const TetMesh mesh = kuhnGrid(40, 40, 40, glm::dvec3(0), glm::dvec3(1), waveField);
  ASSERT_GT(mesh.cellCount(), shared::BATCH_CELLS);
  const Camera camera = cameras()[2];
  const ImageSize size{96, 96};
  const ImageDifference d =
      compareImages(referenceImage(mesh, bands(), camera, size), drawOnce(context(), mesh, bands(), camera, size));
  EXPECT_LE(d.rmse, 5e-4);
}

TEST_F(GpuTest, DegenerateMeshesDrawWithoutNonFinitePixels) {
  TetMesh mesh;
  mesh.points =
      std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}};
  mesh.cells = {{0, 1, 2, 3}, {1, 0, 2, 3}, {0, 1, 2, 3}, {0, 1, 2, 4},
                {0, 0, 1, 2}, {5, 5, 5, 5}, {0, 5, 6, 1}, {1, 2, 3, 5}};
  mesh.pointArrays.push_back({"s", 1, std::vector<float>{0, 1, 0.5f, 0.25f, 0.75f, 0.1f, 0.9f}});
  for (const Camera& camera : cameras()) {
    const Image image = drawOnce(context(), mesh, bands(), camera, {40, 40});
    for (const glm::vec4& p : image.pixels) {
      for (int c = 0; c < 4; c++) EXPECT_TRUE(std::isfinite(p[c]));
      EXPECT_GE(p.w, 0.0f);
      EXPECT_LE(p.w, 1.0f + 1e-6f);
    }
  }
}

TEST_F(GpuTest, PlaceSizeAndUnitsOfTheMeshDoNotShow) {
  const ImageSize size{64, 48};
  const auto draw = [&](double scale, const glm::dvec3& offset, double scalarScale, double scalarOffset) {
    const auto field = [&](const glm::dvec3& p) {
      return scalarOffset + scalarScale * waveField((p - offset) / scale);
    };
    const TetMesh mesh = kuhnGrid(5, 5, 5, offset, offset + glm::dvec3(scale), field);
    std::vector<ControlPoint> points = bands().points();
    for (ControlPoint& p : points) {
      p.s = scalarOffset + scalarScale * p.s;
      p.tau /= scale;
    }
    Camera camera = cameras()[0];
    camera.eye = offset + scale * camera.eye;
    camera.center = offset + scale * camera.center;
    return drawOnce(context(), mesh, TransferFunction(points, "t"), camera, size);
  };
  const Image plain = draw(1, glm::dvec3(0), 1, 0);
  EXPECT_LE(compareImages(plain, draw(1e-9, glm::dvec3(0), 1, 0)).max, 1e-3);
  EXPECT_LE(compareImages(plain, draw(1e9, glm::dvec3(0), 1, 0)).max, 1e-3);
  EXPECT_LE(compareImages(plain, draw(1, glm::dvec3(1e6, -1e6, 1e6), 1, 0)).max, 1e-3);
  EXPECT_LE(compareImages(plain, draw(1, glm::dvec3(0), 1e12, -3e12)).max, 1e-3);
  EXPECT_LE(compareImages(plain, draw(1, glm::dvec3(0), 1e-12, 0)).max, 1e-3);
}

}  // namespace
}  // namespace tetralux::render
