// Frames handed to the device and not waited for, against frames drawn one by one; renderers that start warm.
#include <gtest/gtest.h>

#include <numeric>

#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"
#include "render/warm_pipelines.h"

namespace tetralux::render {
namespace {

using test::GpuTest;

struct Shot {
  Camera camera;
  ImageSize size;
  RenderOptions options;
};

Renderer makeRenderer(const gpu::Context& context, const TetMesh& mesh,
                      CellProjection projection = CellProjection::March, std::unique_ptr<MarchPass> pass = nullptr) {
  return {context, mesh, scalarField(mesh, "", "test"), test::withProjection(projection), std::move(pass)};
}

std::vector<Image> oneByOne(Renderer& renderer, const std::vector<Shot>& shots) {
  std::vector<Image> images;
  for (const Shot& shot : shots) {
    renderer.draw(shot.camera, shot.size, shot.options);
    images.push_back(renderer.readImage());
  }
  return images;
}

// With so many frames begun before the first is finished.
std::vector<Image> inFlight(Renderer& renderer, const std::vector<Shot>& shots, size_t depth) {
  std::vector<Image> images;
  size_t begun = 0;
  while (images.size() < shots.size()) {
    for (; begun < shots.size() && renderer.inFlight() < depth; begun++)
      renderer.begin(shots[begun].camera, shots[begun].size, shots[begun].options);
    images.push_back(renderer.finish().image);
  }
  EXPECT_EQ(renderer.inFlight(), 0u);
  return images;
}

void expectSame(const std::vector<Image>& expected, const std::vector<Image>& found) {
  ASSERT_EQ(expected.size(), found.size());
  for (size_t i = 0; i < expected.size(); i++) {
    ASSERT_EQ(expected[i].pixels.size(), found[i].pixels.size()) << i;
    EXPECT_TRUE(expected[i].pixels == found[i].pixels) << i;
  }
}

std::vector<Shot> turn(const TetMesh& mesh, int count, ImageSize size) {
  std::vector<Shot> shots;
  for (int i = 0; i < count; i++) shots.push_back({test::orderViews(mesh)[0].turned(37.0 * i), size, {}});
  return shots;
}

TEST_F(GpuTest, FramesInFlightAreThoseDrawnOneByOne) {
  const TetMesh mesh = randomDelaunay(2000, 3, waveField);
  std::vector<Shot> shots = turn(mesh, 7, {150, 110});
  // Another size and other kinds of picture between them, an eye inside, and frames that are timed.
  shots[2].size = {90, 160};
  shots[3].options.target = Target::Rgba16f;
  shots[4].options.target = Target::Rgba8;
  shots[5].options.timed = true;
  Camera inside = shots[0].camera;
  inside.eye = {0.5, 0.45, 0.4};
  inside.center = {0.1, 0.9, 0.7};
  shots.push_back({inside, {150, 110}, {}});
  shots.push_back(shots[0]);
  Renderer renderer = makeRenderer(context(), mesh);
  renderer.setTransferFunction(test::orderTransfer());
  const std::vector<Image> expected = oneByOne(renderer, shots);
  for (const size_t depth : {1, 2, 3, 9}) expectSame(expected, inFlight(renderer, shots, depth));
}

TEST_F(GpuTest, FramesThatDoNotFitAreDrawnAgain) {
  // Cells apart from each other: rays enter the mesh far more often than lists have room for at first.
  TetMesh mesh = randomDelaunay(6000, 5, waveField);
  std::vector<std::array<std::uint32_t, 4>> kept;
  for (size_t i = 0; i < mesh.cells.size(); i += 2) kept.push_back(mesh.cells[i]);
  mesh.cells = kept;
  const std::vector<Shot> shots = turn(mesh, 3, {256, 256});
  Renderer first = makeRenderer(context(), mesh);
  first.setTransferFunction(test::orderTransfer());
  const std::vector<Image> expected = oneByOne(first, shots);
  Renderer second = makeRenderer(context(), mesh);
  second.setTransferFunction(test::orderTransfer());
  second.begin(shots[0].camera, shots[0].size);
  const std::uint64_t bytesBefore = second.memoryUse().frameBytes;
  second.begin(shots[1].camera, shots[1].size);
  std::vector<Image> found;
  found.push_back(second.finish().image);
  EXPECT_GT(second.memoryUse().frameBytes, bytesBefore) << "the first frame fitted: this tests nothing";
  second.begin(shots[2].camera, shots[2].size);
  while (second.inFlight() > 0) found.push_back(second.finish().image);
  expectSame(expected, found);
}

TEST_F(GpuTest, ATransferFunctionSetInFlightIsForTheNextFrame) {
  const TetMesh mesh = randomDelaunay(500, 4, waveField);
  const std::vector<Shot> shots = turn(mesh, 1, {64, 48});
  const TransferFunction other({{0, {0.5, 1, 0.25}, 1.5}}, "uniform");
  Renderer renderer = makeRenderer(context(), mesh);
  renderer.setTransferFunction(test::orderTransfer());
  std::vector<Image> expected = oneByOne(renderer, shots);
  renderer.setTransferFunction(other);
  expected.push_back(oneByOne(renderer, shots)[0]);
  renderer.setTransferFunction(test::orderTransfer());
  renderer.begin(shots[0].camera, shots[0].size);
  renderer.setTransferFunction(other);
  renderer.begin(shots[0].camera, shots[0].size);
  expectSame(expected, {renderer.finish().image, renderer.finish().image});
  // What is still in flight when the renderer goes is waited for: validation would tell.
  renderer.begin(shots[0].camera, shots[0].size);
}

TEST_F(GpuTest, CellsThatAreDrawnMayBeInFlightToo) {
  const TetMesh mesh = randomDelaunay(500, 4, waveField);
  const std::vector<Shot> shots = turn(mesh, 3, {64, 48});
  Renderer renderer = makeRenderer(context(), mesh, CellProjection::Silhouette);
  renderer.setTransferFunction(test::orderTransfer());
  const std::vector<Image> expected = oneByOne(renderer, shots);
  expectSame(expected, inFlight(renderer, shots, 2));
}

TEST_F(GpuTest, TablesTakeNoMemoryFromTheDeviceForAShorterTransferFunction) {
  const TetMesh mesh = randomDelaunay(300, 4, waveField);
  Renderer renderer = makeRenderer(context(), mesh);
  std::vector<ControlPoint> points;
  for (int i = 0; i < 300; i++) points.push_back({0.003 * i, {0.1, 0.2, 0.3}, 0.1 * (i % 3)});
  const TransferFunction longer(points, "longer");
  const std::vector<Shot> shots = turn(mesh, 1, {64, 48});
  renderer.setTransferFunction(test::orderTransfer());
  const std::vector<Image> expected = oneByOne(renderer, shots);
  renderer.setTransferFunction(longer);
  const std::uint64_t bytes = renderer.memoryUse().tableBytes;
  renderer.setTransferFunction(test::orderTransfer());
  EXPECT_EQ(renderer.memoryUse().tableBytes, bytes);
  expectSame(expected, oneByOne(renderer, shots));
}

TEST_F(GpuTest, AWarmRendererDrawsWhatAColdOneDoes) {
  const TetMesh mesh = randomDelaunay(500, 4, waveField);
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    std::vector<Shot> shots = turn(mesh, 2, {64, 48});
    for (Shot& shot : shots) {
      shot.camera.projection = projection;
      shot.camera.heightWorld = 2;
    }
    Renderer cold = makeRenderer(context(), mesh);
    cold.setTransferFunction(test::orderTransfer());
    std::unique_ptr<MarchPass> pass = warmPipelines(context(), test::withProjection(CellProjection::March),
                                                    {Projection::Perspective, test::orderTransfer(), {}});
    ASSERT_NE(pass, nullptr);
    Renderer warm = makeRenderer(context(), mesh, CellProjection::March, std::move(pass));
    warm.setTransferFunction(test::orderTransfer());
    expectSame(oneByOne(cold, shots), oneByOne(warm, shots));
  }
  EXPECT_EQ(warmPipelines(context(), test::withProjection(CellProjection::Pt), {}), nullptr);
}

}  // namespace
}  // namespace tetralux::render
