// What the order check counts.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "gpu_fixture.h"
#include "mesh/adjacency.h"
#include "mesh/generate.h"
#include "order_views.h"
#include "pass_scene.h"
#include "support/tilted.h"

namespace tetralux::render {
namespace {

using test::kOrderSize;
using test::OrderedRenderer;
using test::orderTransfer;
using test::orderViews;
using test::PassScene;
using test::reportOf;
using test::runCommands;
using test::tilted;

using OrderCheckTest = test::GpuTest;

// The cull pass's keys for a view.
std::vector<std::uint32_t> cullKeys(const gpu::Context& context, const TetMesh& mesh, const Camera& camera) {
  PassScene scene(context, mesh, orderTransfer(), camera, kOrderSize);
  CullPass pass(context);
  runCommands(context, [&](gpu::CommandBuffer& commands) {
    pass.record(commands, scene.variant, scene.gpuMesh, scene.transfer.support(), scene.storage.view,
                scene.storage.sort.keys(), scene.storage.counters);
  });
  return gpu::downloadVector<std::uint32_t>(context, scene.storage.sort.keys(), scene.gpuMesh.cellCount());
}

// A face of two cells that are in the picture.
struct SharedFace {
  std::uint32_t front;
  std::uint32_t back;
  bool isSure;  // single precision can tell which cell is the one in front
};

// By the definition, in double precision: the cell on the eye's side of the face's plane is in front.
std::vector<SharedFace> sharedFaces(const TetMesh& mesh, const std::vector<std::uint32_t>& keys, const Camera& camera) {
  const Adjacency adjacency = makeAdjacency(mesh);
  std::vector<SharedFace> faces;
  for (std::uint32_t cell = 0; cell < mesh.cellCount(); cell++) {
    CellVertices v = mesh.cells[cell];
    std::sort(v.begin(), v.end());
    for (std::uint32_t k = 0; k < 4; k++) {
      const std::uint32_t other = adjacency.neighbors[cell][k];
      if (other == kNoCell || other < cell || keys[cell] == shared::KEY_OUTSIDE || keys[other] == shared::KEY_OUTSIDE)
        continue;
      const glm::dvec3 a = mesh.point(v[k == 0 ? 1 : 0]);
      const glm::dvec3 e = mesh.point(v[k <= 1 ? 2 : 1]) - a;
      const glm::dvec3 f = mesh.point(v[k <= 2 ? 3 : 2]) - a;
      const glm::dvec3 normal = glm::cross(e, f);
      const glm::dvec3 towardsEye =
          camera.projection == Projection::Perspective ? camera.eye - a : camera.eye - camera.center;
      const double eyeSide = glm::dot(normal, towardsEye);
      const double cellSide = glm::dot(normal, mesh.point(v[k]) - a);
      const bool isFront = (eyeSide > 0.0) == (cellSide > 0.0);
      const double scale = glm::length(e) * glm::length(f) * glm::length(towardsEye);
      faces.push_back({isFront ? cell : other, isFront ? other : cell, std::abs(eyeSide) > 1e-5 * scale});
    }
  }
  return faces;
}

TEST_F(OrderCheckTest, AgreesWithACountInDoublePrecision) {
  for (const TetMesh& mesh :
       {randomDelaunay(1000, 1), tilted(jitteredGrid(7, 7, 7, glm::dvec3(0), glm::dvec3(1), 0.1, 2, waveField))}) {
    OrderedRenderer renderer(context(), mesh, Order::Radix);
    for (const Camera& camera : orderViews(mesh)) {
      const auto keys = cullKeys(context(), mesh, camera);
      std::uint64_t sure = 0, unsure = 0, misordered = 0;
      for (const SharedFace& face : sharedFaces(mesh, keys, camera)) {
        // Smaller keys are drawn first, equal ones by index.
        const bool isFrontFirst = std::pair(keys[face.front], face.front) < std::pair(keys[face.back], face.back);
        (face.isSure ? sure : unsure)++;
        if (face.isSure && isFrontFirst) misordered++;
      }
      const OrderReport report = renderer.draw(camera).order;
      EXPECT_LE(unsure, 3u);
      EXPECT_GE(report.faces, sure);
      EXPECT_LE(report.faces, sure + unsure);
      EXPECT_GE(report.misordered, misordered);
      EXPECT_LE(report.misordered, misordered + unsure);
      EXPECT_GT(misordered, 100u);
    }
  }
}

// Kahn 1962: cells with nothing behind them, then cells with nothing but those behind them, and so on.
std::uint64_t longestChain(size_t cellCount, const std::vector<SharedFace>& faces) {
  std::vector<std::vector<std::uint32_t>> inFront(cellCount);
  std::vector<std::uint32_t> behind(cellCount, 0);
  for (const SharedFace& face : faces) {
    inFront[face.back].push_back(face.front);
    behind[face.front]++;
  }
  std::vector<std::uint32_t> level;
  for (std::uint32_t cell = 0; cell < cellCount; cell++) {
    if (behind[cell] == 0) level.push_back(cell);
  }
  std::uint64_t levels = 0;
  for (; !level.empty(); levels++) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t cell : level) {
      for (const std::uint32_t other : inFront[cell]) {
        if (--behind[other] == 0) next.push_back(other);
      }
    }
    level = std::move(next);
  }
  return levels;
}

TEST_F(OrderCheckTest, LevelsAreTheLongestChainOfCells) {
  const TetMesh mesh = randomDelaunay(1000, 3);
  int compared = 0;
  for (const Camera& camera : orderViews(mesh)) {
    const auto faces = sharedFaces(mesh, cullKeys(context(), mesh, camera), camera);
    if (!std::all_of(faces.begin(), faces.end(), [](const SharedFace& face) { return face.isSure; })) continue;
    EXPECT_EQ(reportOf(context(), mesh, Order::Exact, camera).levels, longestChain(mesh.cellCount(), faces));
    compared++;
  }
  EXPECT_GE(compared, 2);
}

TEST_F(OrderCheckTest, CountsAreTheSameEveryTime) {
  const TetMesh mesh = randomDelaunay(1000, 4);
  const Camera camera = orderViews(mesh)[0];
  for (const Order order : {Order::None, Order::Bucket, Order::Radix, Order::Exact}) {
    OrderedRenderer renderer(context(), mesh, order);
    const OrderReport first = renderer.draw(camera).order;
    EXPECT_EQ(first.order, order);
    renderer.draw(orderViews(mesh)[1]);
    for (const OrderReport& again : {renderer.draw(camera).order, reportOf(context(), mesh, order, camera)}) {
      EXPECT_EQ(again.faces, first.faces);
      EXPECT_EQ(again.misordered, first.misordered);
      EXPECT_EQ(again.levels, first.levels);
      EXPECT_EQ(again.apartCells, first.apartCells);
    }
  }
}

TEST_F(OrderCheckTest, IsNotMadeUnlessAskedFor) {
  const TetMesh mesh = randomDelaunay(200, 5);
  for (const Order order : {Order::Radix, Order::Exact}) {
    RendererOptions options;
    options.order = order;
    Renderer renderer(context(), mesh, scalarField(mesh, "", "test"), options);
    renderer.setTransferFunction(orderTransfer());
    const OrderReport report = renderer.draw(orderViews(mesh)[0], kOrderSize).order;
    EXPECT_EQ(report.order, order);
    EXPECT_FALSE(report.isChecked);
    EXPECT_FALSE(report.isExact()) << "nobody knows";
    EXPECT_EQ(report.faces, 0u);
  }
}

// The faces that count are those of the view, not of the order; and every digit of the key is worth its while.
TEST_F(OrderCheckTest, MoreBitsOfTheKeyMisorderFewerFaces) {
  const TetMesh mesh = randomDelaunay(6000, 6);
  const std::vector<Camera> views = orderViews(mesh);
  std::vector<std::uint64_t> faces(views.size()), misorderedBefore(views.size());
  for (const Order order : {Order::None, Order::Bucket, Order::Radix, Order::Exact}) {
    OrderedRenderer renderer(context(), mesh, order);
    for (const size_t view : {0, 2}) {  // from outside
      const OrderReport report = renderer.draw(views[view]).order;
      if (order != Order::None) {
        EXPECT_EQ(report.faces, faces[view]) << orderName(order);
        EXPECT_LE(report.misordered, misorderedBefore[view]) << orderName(order);
      }
      EXPECT_EQ(report.misordered == 0, order == Order::Exact) << orderName(order);
      faces[view] = report.faces;
      misorderedBefore[view] = report.misordered;
    }
  }
}

TEST_F(OrderCheckTest, KeysMisorderFacesOfATwistedColumn) {
  const TetMesh mesh = twistedDelaunay(1000, 1, 0.25);
  for (const Order order : {Order::None, Order::Bucket, Order::Radix}) {
    OrderedRenderer renderer(context(), mesh, order);
    for (const Camera& camera : orderViews(mesh)) {
      const OrderReport report = renderer.draw(camera).order;
      EXPECT_GT(report.misordered, report.faces / 20) << orderName(order);
      EXPECT_LT(report.misordered, report.faces);
      EXPECT_FALSE(report.isExact());
    }
  }
}

}  // namespace
}  // namespace tetralux::render
