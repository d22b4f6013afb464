// Order across gaps, concavities and seams, where cells hide each other without a shared face.
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
using test::tilted;

using GapOrderTest = test::GpuTest;

// A mesh without the cells for whose middle `isGone` holds.
template <typename IsGone>
TetMesh without(TetMesh mesh, const IsGone& isGone) {
  std::vector<CellVertices> cells;
  for (const CellVertices& v : mesh.cells) {
    if (!isGone(0.25 * (mesh.point(v[0]) + mesh.point(v[1]) + mesh.point(v[2]) + mesh.point(v[3])))) cells.push_back(v);
  }
  mesh.cells = cells;
  return mesh;
}

// Both meshes as one, with points of their own.
TetMesh beside(const TetMesh& a, const TetMesh& b) {
  TetMesh mesh = a;
  auto& points = std::get<std::vector<glm::dvec3>>(mesh.points);
  const auto offset = static_cast<std::uint32_t>(points.size());
  std::vector<double> scalars;
  for (std::uint32_t i = 0; i < b.pointCount(); i++) points.push_back(b.point(i));
  for (const glm::dvec3& p : points) scalars.push_back(waveField(p));
  for (CellVertices v : b.cells) {
    for (std::uint32_t& i : v) i += offset;
    mesh.cells.push_back(v);
  }
  mesh.pointArrays = {{"scalar", 1, scalars}};
  return mesh;
}

TetMesh grid(std::uint32_t n, const glm::dvec3& low, const glm::dvec3& high) {
  return jitteredGrid(n, n, n, low, high, 0.1, 1, waveField);
}

void expectExactPictures(const gpu::Context& context, const TetMesh& mesh, const RendererOptions& options = {}) {
  OrderedRenderer renderer(context, mesh, Order::Exact, options);
  for (const Camera& camera : orderViews(mesh)) {
    const OrderReport report = renderer.draw(camera).order;
    EXPECT_TRUE(report.isExact());
    EXPECT_EQ(report.cyclicCells, 0u);
    const ImageDifference d = compareImages(exactImage(mesh, orderTransfer(), camera), renderer.readImage());
    EXPECT_LE(d.rmse, 5e-5);
    EXPECT_LE(d.max, 1.0 / 255.0);
  }
}

// A block with holes through it, in which a ray may leave and come back several times.
TetMesh sponge() {
  return tilted(without(grid(9, glm::dvec3(0), glm::dvec3(1)), [](const glm::dvec3& p) {
    const glm::ivec3 third = glm::ivec3(p * 3.0);
    return (third.x == 1) + (third.y == 1) + (third.z == 1) >= 2;
  }));
}

TEST_F(GapOrderTest, HolesAndConcavities) { expectExactPictures(context(), sponge()); }

TEST_F(GapOrderTest, ByAddressesToo) {
  RendererOptions options;
  options.forceWideAddressing = true;
  expectExactPictures(context(), sponge(), options);
}

// Two parts that touch along a plane with faces that do not match, as on an O-grid's seam.
TEST_F(GapOrderTest, SeamsWhoseFacesDoNotMatch) {
  expectExactPictures(context(), tilted(beside(grid(5, {0, 0, 0}, {1, 1, 1}), grid(3, {1, 0, 0}, {2, 1, 1}))));
}

TEST_F(GapOrderTest, PartsWithoutContact) {
  TetMesh mesh = grid(3, glm::dvec3(0), glm::dvec3(1));
  for (int i = 1; i < 5; i++)
    mesh = beside(mesh, grid(2, glm::dvec3(1.3 * i, 0.4 * i, 0), glm::dvec3(1.3 * i + 1, 0.4 * i + 1, 1)));
  expectExactPictures(context(), tilted(mesh));
}

TEST_F(GapOrderTest, TheCheckCountsPairsAcrossGaps) {
  // A slab of a few large cells in front of one of many small ones, some of whose centroids are nearer.
  const TetMesh mesh = beside(kuhnGrid(1, 1, 1, {-20, -20, 0}, {20, 20, 1}, waveField),
                              kuhnGrid(8, 8, 1, {-4, -4, 1.2}, {4, 4, 2}, waveField));
  Camera camera;
  camera.eye = {0.1, -0.2, -3};
  camera.center = {0, 0, 1};
  camera.up = {0, 1, 0};
  camera.fovyDegrees = 90;
  const OrderReport radix = test::reportOf(context(), mesh, Order::Radix, camera);
  EXPECT_GT(radix.relations, 1000u);
  EXPECT_GT(radix.misorderedRelations, 0u);
  EXPECT_FALSE(radix.isExact());
  const OrderReport exact = test::reportOf(context(), mesh, Order::Exact, camera);
  EXPECT_EQ(exact.relations, radix.relations);
  EXPECT_EQ(exact.misorderedRelations, 0u);
}

// More pixels than a band of lists holds, and more crossings than they have room for at first.
TEST_F(GapOrderTest, ManyCrossingsInManyBands) {
  TetMesh mesh = kuhnGrid(2, 2, 1, {0, 0, 0}, {1, 1, 0.01}, waveField);
  for (int i = 1; i < 24; i++)
    mesh = beside(mesh, kuhnGrid(2, 2, 1, {0, 0, 0.04 * i}, {1, 1, 0.04 * i + 0.01 + 0.001 * (i % 3)}, waveField));
  RendererOptions options;
  options.order = Order::Exact;
  options.checkOrder = true;
  Renderer renderer(context(), mesh, scalarField(mesh, "", "test"), options);
  renderer.setTransferFunction(orderTransfer());
  Camera camera;
  camera.projection = Projection::Orthographic;
  camera.center = {0.5, 0.5, 0.5};
  camera.eye = {0.7, 0.4, -4};
  camera.up = {0, 1, 0};
  camera.heightWorld = 0.8;
  const OrderReport report = renderer.draw(camera, {600, 300}).order;
  EXPECT_TRUE(report.isExact());
  EXPECT_EQ(report.apartCells, 0u);
  // Every ray through the middle crosses all 23 gaps.
  EXPECT_GT(report.relations, 23u * 300 * 300 / 2);
  EXPECT_GE(report.levels, 24u);
}

}  // namespace
}  // namespace tetralux::render
