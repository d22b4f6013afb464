// The order by power distance: exact on Delaunay meshes, cospherical cells included, and on any part of one.
#include "render/order/power_order.h"

#include <ostream>

#include "gpu_fixture.h"
#include "image/metrics.h"
#include "mesh/generate.h"
#include "mesh/random.h"
#include "order_views.h"
#include "support/tilted.h"

namespace tetralux::render {
namespace {

using test::exactImage;
using test::OrderedRenderer;
using test::orderTransfer;
using test::orderViews;
using test::tilted;

using PowerOrderTest = test::GpuTest;

// About that share of the cells, at random.
TetMesh partOf(TetMesh mesh, double share) {
  std::vector<CellVertices> kept;
  for (size_t i = 0; i < mesh.cellCount(); i++) {
    if (randomUnit(5, i) < share) kept.push_back(mesh.cells[i]);
  }
  mesh.cells = std::move(kept);
  mesh.cellArrays.clear();
  return mesh;
}

TetMesh moved(TetMesh mesh, const glm::dvec3& by) {
  for (glm::dvec3& p : std::get<std::vector<glm::dvec3>>(mesh.points)) p += by;
  return mesh;
}

// Those of orderViews() and one from a thousand times the mesh's size away.
std::vector<Camera> views(const TetMesh& mesh) {
  std::vector<Camera> result = orderViews(mesh);
  const Bounds bounds = mesh.bounds();
  Camera far;
  far.center = bounds.center();
  far.eye = far.center + 1000.0 * bounds.diagonal() * glm::dvec3(0.48, -0.8, 0.36);
  far.fovyDegrees = 0.06;
  result.push_back(far);
  return result;
}

struct DelaunayMesh {
  const char* name;
  TetMesh (*make)();

  friend std::ostream& operator<<(std::ostream& out, const DelaunayMesh& mesh) { return out << mesh.name; }
};

constexpr DelaunayMesh kDelaunayMeshes[] = {
    {"random", [] { return randomDelaunay(3000, 1); }},
    {"randomTilted", [] { return tilted(randomDelaunay(3000, 2)); }},
    {"farFromTheOrigin",
     [] {
       return moved(randomDelaunay(2000, 3), {1e6, -1e6, 1e6});
     }},
    {"aTenth", [] { return partOf(randomDelaunay(6000, 4), 0.1); }},
    {"half", [] { return partOf(randomDelaunay(3000, 5), 0.5); }},
    {"orbital", [] { return hydrogenOrbital(20000, 1); }},
    {"grid", [] { return kuhnGrid(11, 9, 10, glm::dvec3(0), glm::dvec3(1.1, 0.9, 1), waveField); }},
    {"gridTilted", [] { return tilted(kuhnGrid(11, 9, 10, glm::dvec3(0), glm::dvec3(1.1, 0.9, 1), waveField)); }},
    {"cell", [] { return partOf(kuhnGrid(1, 1, 1, glm::dvec3(0), glm::dvec3(1), waveField), 0.3); }},
};

class DelaunayOrderTest : public test::GpuTest, public ::testing::WithParamInterface<DelaunayMesh> {};

TEST_P(DelaunayOrderTest, HasNoMisorderedFaceAndDrawsThePictureOfTheReference) {
  const TetMesh mesh = GetParam().make();
  for (const bool wideAddressing : {false, true}) {
    RendererOptions options;
    options.forceWideAddressing = wideAddressing;
    OrderedRenderer renderer(context(), mesh, Order::Power, options);
    for (const Camera& camera : views(mesh)) {
      const OrderReport report = renderer.draw(camera).order;
      EXPECT_EQ(report.order, Order::Power);
      EXPECT_TRUE(report.isChecked);
      EXPECT_EQ(report.misordered, 0u) << "of " << report.faces;
      if (wideAddressing) continue;
      const ImageDifference d = compareImages(exactImage(mesh, orderTransfer(), camera), renderer.readImage());
      EXPECT_LE(d.rmse, 5e-4);
      EXPECT_EQ(d.nonFinite, 0u);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, DelaunayOrderTest, ::testing::ValuesIn(kDelaunayMeshes),
                         [](const auto& mesh) { return mesh.param.name; });

// Single precision would get some of these wrong: 3 to 5 of 490,000 in every view.
TEST_F(PowerOrderTest, HasNoMisorderedFaceInAQuarterOfAMillionCells) {
  const TetMesh mesh = randomDelaunay(40000, 1);
  RendererOptions options;
  options.order = Order::Power;
  options.checkOrder = true;
  Renderer renderer(context(), mesh, scalarField(mesh, "", "test"), options);
  renderer.setTransferFunction(TransferFunction({{0, {1, 1, 1}, 0}, {1, {1, 1, 1}, 1}}, "ramp"));
  for (const Camera& camera : views(mesh)) {
    const OrderReport report = renderer.draw(camera, {512, 512}).order;
    EXPECT_EQ(report.misordered, 0u) << "of " << report.faces;
    EXPECT_GT(report.faces, 50000u);
  }
}

TEST_F(PowerOrderTest, IsTheSameEveryTimeAndForEitherSort) {
  const TetMesh mesh = kuhnGrid(12, 12, 12, glm::dvec3(0), glm::dvec3(1), waveField);
  const Camera camera = orderViews(mesh).front();
  std::vector<Image> images;
  for (const SortVariant variant : {SortVariant::Chunks, SortVariant::Chunks, SortVariant::Tiles}) {
    RendererOptions options;
    options.sortVariant = variant;
    OrderedRenderer renderer(context(), mesh, Order::Power, options);
    for (int i = 0; i < 2; i++) {
      renderer.draw(camera);
      images.push_back(renderer.readImage());
    }
  }
  for (const Image& image : images) EXPECT_TRUE(image.pixels == images[0].pixels);
}

TEST_F(PowerOrderTest, KnowsWhenAMeshIsNotDelaunay) {
  const TetMesh mesh = flattenedDelaunay(2000, 1, 0.1);
  OrderedRenderer renderer(context(), mesh, Order::Power);
  for (const Camera& camera : orderViews(mesh)) EXPECT_GT(renderer.draw(camera).order.misordered, 0u);
}

// Cells without a volume, and spheres as good as planes, make no key that is not a number.
TEST_F(PowerOrderTest, DrawsMeshesWithDegenerateCells) {
  TetMesh mesh = randomDelaunay(500, 2);
  const CellVertices v = mesh.cells[7];
  mesh.cells.push_back({v[0], v[0], v[1], v[2]});
  mesh.cells.push_back({v[3], v[3], v[3], v[3]});
  auto& points = std::get<std::vector<glm::dvec3>>(mesh.points);
  auto& values = mesh.pointArrays;
  values.clear();
  const auto first = static_cast<std::uint32_t>(points.size());
  for (const glm::dvec3& p :
       {glm::dvec3(0.2, 0.2, 0.5), {0.8, 0.2, 0.5}, {0.2, 0.8, 0.5}, {0.7, 0.7, 0.5}, {0.7, 0.7, 0.5 + 1e-16}})
    points.push_back(p);
  mesh.cells.push_back({first, first + 1, first + 2, first + 3});
  mesh.cells.push_back({first, first + 1, first + 2, first + 4});
  addPointField(mesh, "scalar", waveField);
  OrderedRenderer renderer(context(), mesh, Order::Power);
  for (const Camera& camera : orderViews(mesh)) {
    renderer.draw(camera);
    EXPECT_EQ(compareImages(exactImage(mesh, orderTransfer(), camera), renderer.readImage()).nonFinite, 0u);
  }
}

}  // namespace
}  // namespace tetralux::render
