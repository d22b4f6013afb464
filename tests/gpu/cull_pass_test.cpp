#include "render/cull_pass.h"

#include <glm/geometric.hpp>

#include "gpu_fixture.h"
#include "pass_scene.h"
#include "reference/cell_ray.h"
#include "shared/limits.h"

namespace tetralux::render {
namespace {

using shared::KEY_TRANSPARENT;
using test::GpuTest;
using test::PassScene;
using test::runCommands;

std::vector<std::uint32_t> cullKeys(PassScene& scene) {
  CullPass pass(scene.context);
  runCommands(scene.context, [&](gpu::CommandBuffer& commands) {
    pass.record(commands, scene.variant, scene.gpuMesh, scene.transfer.support(), scene.storage.view,
                scene.storage.sort.keys(), scene.storage.counters);
  });
  return gpu::downloadVector<std::uint32_t>(scene.context, scene.storage.sort.keys(), scene.gpuMesh.cellCount());
}

const TransferFunction& everywhere() {
  static const TransferFunction transfer({{0, {1, 1, 1}, 1}}, "everywhere");
  return transfer;
}

std::vector<Camera> cameras() {
  std::vector<Camera> result(5);
  result[0].eye = {2, -3, 1.5};        // all in view
  result[1].eye = {0.5, -0.4, 0.5};    // a part in view
  result[2].eye = {0.45, 0.55, 0.35};  // inside
  result[3].eye = {0.5, 0.3, 0.4};     // orthographic, the eye's plane cuts the mesh
  result[4].eye = {40, -60, 30};       // cells far smaller than pixels
  for (Camera& camera : result) camera.center = {0.5, 0.5, 0.5};
  result[3].projection = Projection::Orthographic;
  result[3].heightWorld = 0.7;
  return result;
}

// No cell that a pixel's ray meets may be culled. What is kept without being met costs time only, and is bounded.
TEST_F(GpuTest, CullKeepsEveryCellThatARayMeets) {
  const ImageSize size{48, 36};
  for (const Camera& camera : cameras()) {
    PassScene scene(context(), randomDelaunay(400, 1), everywhere(), camera, size);
    const auto keys = cullKeys(scene);
    size_t kept = 0;
    size_t met = 0;
    for (size_t cell = 0; cell < keys.size(); cell++) {
      const CellVertices& v = scene.mesh.cells[cell];
      const reference::CellGeometry geometry(
          {scene.mesh.point(v[0]), scene.mesh.point(v[1]), scene.mesh.point(v[2]), scene.mesh.point(v[3])}, {});
      bool isMet = false;
      reference::CellSegment segment;
      for (std::uint32_t i = 0; i < size.width * size.height && !isMet; i++) {
        isMet = geometry.intersect(camera.pixelRay(size, i % size.width, i / size.width), segment) &&
                segment.back - segment.front > 1e-6;
      }
      EXPECT_FALSE(isMet && keys[cell] >= KEY_TRANSPARENT) << cell;
      kept += keys[cell] < KEY_TRANSPARENT ? 1 : 0;
      met += isMet ? 1 : 0;
    }
    const auto counters = scene.counters();
    EXPECT_EQ(counters.outside + counters.noSample + counters.transparent + kept, keys.size());
    EXPECT_LE(kept, 1.5 * static_cast<double>(met) + 20);
  }
}

TEST_F(GpuTest, CullKeysOrderCellsByTheDistanceOfTheirCentroids) {
  for (const Camera& camera : cameras()) {
    PassScene scene(context(), randomDelaunay(400, 2), everywhere(), camera, {64, 64});
    const auto keys = cullKeys(scene);
    const glm::dvec3 forward = glm::normalize(camera.center - camera.eye);
    std::vector<std::pair<double, std::uint32_t>> byDistance;
    for (size_t cell = 0; cell < keys.size(); cell++) {
      if (keys[cell] >= KEY_TRANSPARENT) continue;
      glm::dvec3 centroid(0);
      for (const std::uint32_t vertex : scene.mesh.cells[cell]) centroid += 0.25 * scene.mesh.point(vertex);
      const glm::dvec3 d = centroid - camera.eye;
      byDistance.emplace_back(scene.setup.perspective ? glm::length(d) : glm::dot(d, forward), keys[cell]);
    }
    std::sort(byDistance.begin(), byDistance.end());
    for (size_t i = 1; i < byDistance.size(); i++) {
      // Single precision may turn round what is this close.
      if (byDistance[i].first - byDistance[i - 1].first > 1e-5 * byDistance[i].first) {
        EXPECT_LE(byDistance[i].second, byDistance[i - 1].second);
      }
    }
  }
}

TEST_F(GpuTest, CullTestsTheScalarRangeAndNotTheVertices) {
  TetMesh mesh = kuhnGrid(1, 1, 1, glm::dvec3(0), glm::dvec3(1), [](const glm::dvec3& p) { return p.x; });
  Camera camera;
  camera.eye = {0.5, -3, 0.5};
  camera.center = {0.5, 0, 0.5};
  // A peak between the vertices' values 0 and 1; then extinction only beyond them, only touching them, and none.
  const auto transparent = [&](std::vector<ControlPoint> points) {
    PassScene scene(context(), mesh, TransferFunction(points, "t"), camera, {16, 16});
    cullKeys(scene);
    return scene.counters().transparent;
  };
  EXPECT_EQ(transparent({{0.4, {}, 0}, {0.5, {}, 1}, {0.6, {}, 0}}), 0u);
  EXPECT_EQ(transparent({{1.5, {}, 0}, {2, {}, 1}}), 6u);
  EXPECT_EQ(transparent({{1, {}, 0}, {2, {}, 1}}), 6u);
  EXPECT_EQ(transparent({{0, {}, 0}}), 6u);
  EXPECT_EQ(transparent({{1, {}, 0}, {1, {}, 1}}), 0u) << "a vertex exactly on a step up";
  // Normalised to 0: the next number below is one that devices may take for 0.
  mesh.pointArrays[0].values = std::vector<float>(mesh.pointCount(), 0.5f);
  EXPECT_EQ(transparent({{0.5, {}, 0}, {0.5, {}, 1}}), 0u) << "all on a step up";
  EXPECT_EQ(transparent({{0.5, {}, 0}, {1, {}, 1}}), 6u) << "all where a slope begins";
}

TEST_F(GpuTest, CullCountsCellsBehindTheEyeAndBesideTheImageAsOutside) {
  Camera camera;
  camera.eye = {0.5, -3, 0.5};
  camera.center = {0.5, -4, 0.5};
  PassScene behind(context(), kuhnGrid(2, 2, 2, glm::dvec3(0), glm::dvec3(1), waveField), everywhere(), camera,
                   {16, 16});
  cullKeys(behind);
  EXPECT_EQ(behind.counters().outside, 48u);
  camera.center = {9, -3, 0.5};
  PassScene beside(context(), kuhnGrid(2, 2, 2, glm::dvec3(0), glm::dvec3(1), waveField), everywhere(), camera,
                   {16, 16});
  cullKeys(beside);
  EXPECT_EQ(beside.counters().outside, 48u);
}

}  // namespace
}  // namespace tetralux::render
