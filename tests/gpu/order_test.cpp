// The order in which cells are drawn, as the renderer's statistics and pictures show it.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <ostream>
#include <random>

#include "gpu_fixture.h"
#include "image/metrics.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "support/tilted.h"

namespace tetralux::render {
namespace {

using test::exactImage;
using test::kOrderSize;
using test::OrderedRenderer;
using test::orderTransfer;
using test::orderViews;
using test::reportOf;
using test::tilted;

using OrderTest = test::GpuTest;

// No face is inverted by the twist, as some are in twistedDelaunay().
TetMesh twistedGrid(std::uint32_t n, double turns) {
  TetMesh mesh = kuhnGrid(n, n, 3 * n, {-0.5, -0.5, 0.0}, {0.5, 0.5, 3.0}, waveField);
  for (glm::dvec3& p : std::get<std::vector<glm::dvec3>>(mesh.points)) {
    const double angle = 2.0 * std::numbers::pi * turns * p.z / 3.0;
    p = {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y, p.z};
  }
  return mesh;
}

// The same cells in another order, each with its vertices in another order.
TetMesh shuffled(TetMesh mesh) {
  std::mt19937 random(1);
  std::shuffle(mesh.cells.begin(), mesh.cells.end(), random);
  for (CellVertices& cell : mesh.cells) std::shuffle(cell.begin(), cell.end(), random);
  return mesh;
}

struct AcyclicMesh {
  const char* name;
  TetMesh (*make)();

  friend std::ostream& operator<<(std::ostream& out, const AcyclicMesh& mesh) { return out << mesh.name; }
};

// Delaunay meshes have no cycles (Edelsbrunner 1990), nor has what an affine map makes of them, nor a chain; of the
// others it is known by trying.
constexpr AcyclicMesh kAcyclicMeshes[] = {
    {"delaunay", [] { return randomDelaunay(1000, 1); }},
    {"delaunayTilted", [] { return tilted(randomDelaunay(1000, 2)); }},
    {"flattened", [] { return flattenedDelaunay(1000, 3, 1.0 / 64.0); }},
    {"veryFlatTilted", [] { return tilted(flattenedDelaunay(1000, 3, 1e-4)); }},
    {"jitteredGridTilted",
     [] { return tilted(jitteredGrid(8, 8, 8, glm::dvec3(0), glm::dvec3(1), 0.15, 1, waveField)); }},
    {"gradedBox", [] { return gradedBox(8, 1e4); }},
    {"gradedBoxTilted", [] { return tilted(gradedBox(8, 1e3)); }},
    {"needlesTilted", [] { return tilted(gradedBox(8, 1e5)); }},
    {"twistedGrid", [] { return twistedGrid(4, 0.25); }},
    {"sliverChain", [] { return sliverChain(40, 0.5); }},
    {"steepSliverChain", [] { return sliverChain(12, 0.125); }},
    {"orbital", [] { return hydrogenOrbital(5000, 1); }},
};

class ExactOrderTest : public test::GpuTest, public ::testing::WithParamInterface<AcyclicMesh> {};

TEST_P(ExactOrderTest, HasNoMisorderedFaceAndDrawsThePictureOfTheReference) {
  const TetMesh mesh = GetParam().make();
  OrderedRenderer renderer(context(), mesh, Order::Exact);
  for (const Camera& camera : orderViews(mesh)) {
    const FrameStats stats = renderer.draw(camera);
    EXPECT_EQ(stats.order.order, Order::Exact);
    EXPECT_TRUE(stats.order.isChecked);
    EXPECT_TRUE(stats.order.isExact());
    EXPECT_EQ(stats.order.misordered, 0u);
    EXPECT_EQ(stats.order.cyclicCells, 0u);
    EXPECT_EQ(stats.order.apartCells, 0u);
    EXPECT_GT(stats.order.faces, 0u);
    EXPECT_GT(stats.order.levels, 1u);
    EXPECT_LE(stats.order.levels, stats.drawnCells + stats.culledTransparent);
    const ImageDifference d = compareImages(exactImage(mesh, orderTransfer(), camera), renderer.readImage());
    EXPECT_LE(d.rmse, 5e-5);
    EXPECT_EQ(d.nonFinite, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, ExactOrderTest, ::testing::ValuesIn(kAcyclicMeshes),
                         [](const auto& mesh) { return std::string(mesh.param.name); });

TEST_F(OrderTest, ExactHasNoMisorderedFaceFromAnywhere) {
  const TetMesh mesh = tilted(randomDelaunay(500, 4));
  const Bounds bounds = mesh.bounds();
  OrderedRenderer renderer(context(), mesh, Order::Exact);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 24; i++) {
    Camera camera;
    camera.center = bounds.center();
    // Inside and outside the mesh, and at some of its vertices, in the planes of many faces.
    camera.eye = i % 4 == 0 ? mesh.point(static_cast<size_t>(17 * i)) + glm::dvec3(0.0, 0.0, i % 8 == 0 ? 0.0 : 1e-7)
                            : bounds.center() +
                                  bounds.diagonal() * glm::dvec3(uniform(random), uniform(random), uniform(random));
    camera.fovyDegrees = 80.0;
    const OrderReport report = renderer.draw(camera).order;
    EXPECT_EQ(report.misordered, 0u) << i;
    EXPECT_EQ(report.apartCells, 0u) << i;
  }
}

// Along an axis, and along the diagonals of the boxes, the eye lies in the planes of whole layers of faces.
TEST_F(OrderTest, ExactHasNoMisorderedFaceAlongTheFacesOfAGrid) {
  const TetMesh mesh = kuhnGrid(6, 6, 6, glm::dvec3(0), glm::dvec3(1), waveField);
  OrderedRenderer renderer(context(), mesh, Order::Exact);
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    for (const glm::dvec3& direction : {glm::dvec3(0, 1, 0), {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}}) {
      Camera camera;
      camera.projection = projection;
      camera.center = glm::dvec3(0.5);
      camera.eye = camera.center - 2.0 * direction;
      camera.fovyDegrees = 45.0;
      camera.heightWorld = 1.1;
      const OrderReport report = renderer.draw(camera).order;
      EXPECT_TRUE(report.isExact());
      EXPECT_EQ(report.apartCells, 0u);
      EXPECT_LE(compareImages(exactImage(mesh, orderTransfer(), camera), renderer.readImage()).rmse, 5e-5);
    }
  }
}

TEST_F(OrderTest, ExactPictureDoesNotDependOnTheOrderOfTheFile) {
  for (const TetMesh& mesh : {tilted(randomDelaunay(1000, 5)), gradedBox(6, 100.0)}) {
    OrderedRenderer renderer(context(), mesh, Order::Exact);
    OrderedRenderer shuffledRenderer(context(), shuffled(mesh), Order::Exact);
    for (const Camera& camera : orderViews(mesh)) {
      const OrderReport report = renderer.draw(camera).order;
      const OrderReport shuffledReport = shuffledRenderer.draw(camera).order;
      EXPECT_EQ(report.faces, shuffledReport.faces);
      EXPECT_EQ(report.levels, shuffledReport.levels);
      EXPECT_LE(compareImages(renderer.readImage(), shuffledRenderer.readImage()).max, 1e-6);
    }
  }
}

// Rays pass through transparent cells: what lies before and behind them is ordered through them.
TEST_F(OrderTest, ExactOrderReachesThroughTransparentCells) {
  const TransferFunction shells({{0.3, {0.9, 0.1, 0.1}, 8}, {0.35, {}, 0}, {0.65, {}, 0}, {0.7, {0.1, 0.2, 0.9}, 8}},
                                "shells");
  const TetMesh mesh = tilted(randomDelaunay(1000, 6));
  OrderedRenderer renderer(context(), mesh, Order::Exact);
  for (const Camera& camera : orderViews(mesh)) {
    const OrderReport opaque = renderer.draw(camera).order;
    renderer.setTransferFunction(shells);
    const FrameStats stats = renderer.draw(camera);
    EXPECT_GT(stats.culledTransparent, 20u);
    EXPECT_EQ(stats.order.faces, opaque.faces);
    EXPECT_EQ(stats.order.levels, opaque.levels);
    EXPECT_TRUE(stats.order.isExact());
    EXPECT_LE(compareImages(exactImage(mesh, shells, camera), renderer.readImage()).rmse, 5e-5);
    renderer.setTransferFunction(orderTransfer());
  }
}

TEST_F(OrderTest, ExactOrderOfOneCellAndOfNone) {
  const TetMesh chain = sliverChain(1, 0.5);
  Camera camera = orderViews(chain)[0];
  OrderedRenderer renderer(context(), chain, Order::Exact);
  const FrameStats one = renderer.draw(camera);
  EXPECT_EQ(one.drawnCells, 1u);
  EXPECT_EQ(one.order.levels, 1u);
  EXPECT_EQ(one.order.faces, 0u);
  camera.center = camera.eye + camera.eye - camera.center;  // turned away
  const FrameStats none = renderer.draw(camera);
  EXPECT_EQ(none.drawnCells, 0u);
  EXPECT_EQ(none.order.levels, 0u);
  EXPECT_TRUE(none.order.isExact());
  for (const glm::vec4& pixel : renderer.readImage().pixels) EXPECT_EQ(pixel, glm::vec4(0));
}

// More levels than one run of the peeling shader takes, because Mesa's software device ends loops after 65535 rounds.
TEST_F(OrderTest, ExactOrderOfAChainOfManyThousandLevels) {
  constexpr std::uint32_t kBoxes = 25000;
  const TetMesh mesh = kuhnGrid(1, 1, kBoxes, glm::dvec3(0), glm::dvec3(1), waveField);
  Camera camera;
  camera.projection = Projection::Orthographic;
  camera.center = {0.5, 0.5, 0.5};
  camera.eye = {0.53, 0.46, -1.0};
  camera.up = {0, 1, 0};
  camera.heightWorld = 0.9;
  RendererOptions options;
  options.order = Order::Exact;
  options.checkOrder = true;
  Renderer renderer(context(), mesh, scalarField(mesh, "", "test"), options);
  renderer.setTransferFunction(orderTransfer());
  const OrderReport report = renderer.draw(camera, {4, 4}).order;
  EXPECT_TRUE(report.isExact());
  EXPECT_EQ(report.apartCells, 0u);
  EXPECT_GT(report.levels, 65536u);
}

TEST_F(OrderTest, EveryCodePathCountsTheSame) {
  const TetMesh mesh = tilted(randomDelaunay(1000, 7));
  const Camera camera = orderViews(mesh)[0];
  for (const Order order : {Order::Exact, Order::Radix}) {
    const OrderReport expected = reportOf(context(), mesh, order, camera);
    for (const bool wide : {false, true}) {
      for (const SortVariant variant : {SortVariant::Tiles, SortVariant::Chunks}) {
        RendererOptions options;
        options.forceWideAddressing = wide;
        options.sortVariant = variant;
        const OrderReport report = OrderedRenderer(context(), mesh, order, options).draw(camera).order;
        EXPECT_EQ(report.faces, expected.faces);
        EXPECT_EQ(report.misordered, expected.misordered);
        EXPECT_EQ(report.levels, expected.levels);
      }
    }
  }
}

// Visibility cycles.

void expectCycle(const gpu::Context& context, const TetMesh& mesh, const Camera& camera, std::uint64_t cyclicCells) {
  OrderedRenderer renderer(context, mesh, Order::Exact);
  const OrderReport report = renderer.draw(camera).order;
  EXPECT_EQ(report.cyclicCells, cyclicCells);
  EXPECT_GE(report.apartCells, cyclicCells);
  EXPECT_EQ(report.misordered, 0u);
  EXPECT_EQ(report.misorderedRelations, 0u);
  EXPECT_LE(compareImages(exactImage(mesh, orderTransfer(), camera), renderer.readImage()).rmse, 5e-5);
}

// Along +z and along -z, from near and from far.
std::vector<Camera> axisViews(double middle) {
  std::vector<Camera> views;
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    for (const double distance : {-40.0, -5.0, 5.0, 40.0}) {
      Camera camera;
      camera.projection = projection;
      camera.center = {0, 0, middle};
      camera.eye = {0, 0, middle + distance};
      camera.up = {0, 1, 0};
      camera.fovyDegrees = 200.0 / std::abs(distance);
      camera.heightWorld = 5.0;
      views.push_back(camera);
    }
  }
  return views;
}

TEST_F(OrderTest, ThreeSeparateCellsInACycle) {
  for (const Camera& camera : axisViews(0.0)) expectCycle(context(), cyclicTriple(), camera, 3);
}

TEST_F(OrderTest, NineCellsOfAConvexMeshInACycle) {
  for (const Camera& camera : axisViews(0.5)) expectCycle(context(), cyclicOctahedron(), camera, 9);
}

// Where the column's cells have turned over, two cells on one side of their face overlap: cycles of two, and larger
// ones.
TEST_F(OrderTest, FoldsAreCycles) {
  const TetMesh mesh = twistedDelaunay(1000, 1, 0.25);
  OrderedRenderer renderer(context(), mesh, Order::Exact);
  for (const Camera& camera : orderViews(mesh)) {
    const OrderReport report = renderer.draw(camera).order;
    EXPECT_GE(report.cyclicCells, 2u);
    EXPECT_GE(report.apartCells, report.cyclicCells);
    EXPECT_EQ(report.misordered, 0u);
    EXPECT_LE(compareImages(exactImage(mesh, orderTransfer(), camera), renderer.readImage()).rmse, 5e-5);
  }
}

}  // namespace
}  // namespace tetralux::render
