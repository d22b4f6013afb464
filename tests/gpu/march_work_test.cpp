// What rays have to do, counted: against meshes of which the number of cells along a ray is known.
#include <gtest/gtest.h>

#include "gpu_fixture.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "projection_views.h"
#include "render/floor_times.h"
#include "render/pass_work.h"

namespace tetralux::render {
namespace {

using test::GpuTest;

constexpr std::uint32_t kLayers = 5;
constexpr ImageSize kSize{60, 40};
constexpr std::uint64_t kPixels = 60 * 40;

// Along z, in parallel, within the mesh everywhere, no ray on a face of a cell.
Camera alongLayers() {
  Camera camera;
  camera.projection = Projection::Orthographic;
  camera.eye = {0.511, 0.497, 4.0};
  camera.center = {0.511, 0.497, 0.0};
  camera.up = {0, 1, 0};
  camera.heightWorld = 0.6;
  return camera;
}

// A box of layers; along z a ray meets three of a box's six tetrahedra.
TetMesh layeredBox() { return kuhnGrid(3, 2, kLayers, glm::dvec3(0), glm::dvec3(1), waveField); }

struct Counted {
  FrameStats stats;
  Image image;
};

Counted countedFrame(const gpu::Context& context, const TetMesh& mesh, const TransferFunction& transfer,
                     const Camera& camera, bool countWork = true, bool doublePrecision = false) {
  RendererOptions options = test::withProjection(CellProjection::March);
  if (doublePrecision) options.doublePrecision = true;
  Renderer renderer(context, mesh, scalarField(mesh, "", "test"), options);
  renderer.setTransferFunction(transfer);
  RenderOptions counting;
  counting.countWork = countWork;
  Counted counted;
  counted.stats = renderer.draw(camera, kSize, counting);
  counted.image = renderer.readImage();
  return counted;
}

TEST_F(GpuTest, MarchCountsTheCellsOfEveryRay) {
  const TransferFunction faint({{0.0, glm::dvec3(1), 0.01}}, "test");  // one piece, nothing is opaque
  for (const bool doublePrecision : {false, true}) {
    if (doublePrecision && !context().info().hasFloat64) continue;
    const FrameStats stats = countedFrame(context(), layeredBox(), faint, alongLayers(), true, doublePrecision).stats;
    ASSERT_TRUE(stats.march);
    EXPECT_EQ(stats.march->entries, kPixels);
    EXPECT_EQ(stats.march->cells, kPixels * kLayers * 3);
    EXPECT_EQ(stats.march->parts, stats.march->cells);
    EXPECT_GE(stats.march->jobs, kPixels / 64);
    EXPECT_GT(stats.march->faces, 0u);
  }
}

TEST_F(GpuTest, MarchCountsPartsOfCellsAtControlPoints) {
  const Counted counted = countedFrame(context(), layeredBox(), test::orderTransfer(), alongLayers());
  EXPECT_GT(counted.stats.march->parts, counted.stats.march->cells);
}

// Timed frames are not those that count.
TEST_F(GpuTest, MarchCountsOnlyWhenAskedAndDrawsTheSame) {
  const TetMesh mesh = randomDelaunay(1500, 7);
  for (const Camera& camera : test::orderViews(mesh)) {
    const Counted counted = countedFrame(context(), mesh, test::orderTransfer(), camera);
    const Counted plain = countedFrame(context(), mesh, test::orderTransfer(), camera, /*countWork=*/false);
    EXPECT_FALSE(plain.stats.march);
    EXPECT_EQ(counted.image.pixels, plain.image.pixels);
    EXPECT_GT(counted.stats.march->cells, 1000u);
  }
}

TEST_F(GpuTest, BesideTheMeshThereIsNothingToDo) {
  const TetMesh mesh = randomDelaunay(500, 3);
  std::vector<Camera> views = test::orderViews(mesh);
  views.push_back(alongLayers());
  for (const Camera& camera : views) {
    const ScalarField field = scalarField(mesh, "", "test");
    const Camera beside = besideMesh(camera, kSize, makeMeshSpace(mesh, field));
    const FrameStats stats = countedFrame(context(), mesh, test::orderTransfer(), beside).stats;
    EXPECT_EQ(stats.march->jobs, 0u);
    EXPECT_EQ(stats.march->entries, 0u);
    EXPECT_EQ(stats.march->cells, 0u);
  }
}

TEST(PassWork, OfTheMarchNeedsCountedWork) {
  FrameStats stats;
  stats.passes = {{"enter", 1.0}, {"march", 2.0}};
  EXPECT_FALSE(passWork(stats, 100, 50, {8, 4})[1].bytes);
  stats.march = MarchWork{10, 4, 7, 100, 130};
  const std::vector<PassWork> work = passWork(stats, 100, 50, {8, 4});
  // 10 faces of 16 bytes and 5 vertices; 4 jobs of 16, twice; 7 nodes of 12 and their lists' heads; 32 pixels.
  EXPECT_EQ(work[0].bytes, 10 * 16 + 5 * 16 + 4 * 32 + 7 * 20 + 32 * 20);
  EXPECT_EQ(work[0].items, 4u);
  // 7 entries with node, cell and three vertices; 100 steps of 8 bytes and a vertex; 32 pixels of a head, a colour, a
  // picture.
  EXPECT_EQ(work[1].bytes, 7 * (12 + 16 + 48) + 100 * 24 + 32 * 36);
  EXPECT_EQ(work[1].items, 100u);
  EXPECT_EQ(work[1].counts.back(), (std::pair<std::string, std::uint64_t>("parts", 130)));
}

}  // namespace
}  // namespace tetralux::render
