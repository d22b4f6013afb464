#include "render/project_pass.h"

#include <glm/geometric.hpp>
#include <optional>
#include <random>

#include "gpu_fixture.h"
#include "pass_scene.h"
#include "reference/cell_ray.h"
#include "render/truth_table.h"

namespace tetralux::render {
namespace {

using shared::FAN_VERTICES;
using test::GpuTest;
using test::PassScene;
using test::runCommands;

struct Fan {
  std::array<glm::vec2, FAN_VERTICES> position;  // ndc
  std::array<glm::vec4, FAN_VERTICES> ends;
  bool isClipped;  // the ends are the normals of the four faces, vertex 0, view space, and the scalars
};

// Projects all cells in the order of their indices.
std::vector<Fan> projectAll(PassScene& scene) {
  ProjectPass pass(scene.context);
  const GpuTruthTable truthTable(scene.context);
  const std::uint32_t count = scene.gpuMesh.cellCount();
  std::vector<std::uint32_t> identity(count);
  for (std::uint32_t i = 0; i < count; i++) identity[i] = i;
  const gpu::Buffer order = gpu::makeBuffer(scene.context, identity, "order");
  const gpu::TexelView orderView(scene.context, order, VK_FORMAT_R32_UINT);
  const gpu::Buffer kept = gpu::makeBuffer(scene.context, std::vector<std::uint32_t>{count}, "kept");
  runCommands(scene.context, [&](gpu::CommandBuffer& commands) {
    CellSequence sequence;
    sequence.order = &order;
    sequence.orderView = &orderView;
    sequence.kept = &kept;
    pass.recordBatch(commands, scene.variant, scene.gpuMesh, scene.transfer, truthTable, scene.storage.view, sequence,
                     {0, count}, scene.storage.counters, scene.storage.batches, /*isCounted=*/true);
  });
  const auto positions =
      gpu::downloadVector<glm::vec2>(scene.context, scene.storage.batches.positions, count * FAN_VERTICES);
  const auto ends = gpu::downloadVector<glm::vec4>(scene.context, scene.storage.batches.ends, count * FAN_VERTICES);
  const auto modes = gpu::downloadVector<std::uint32_t>(scene.context, scene.storage.batches.modes, count);
  std::vector<Fan> fans(count);
  for (std::uint32_t cell = 0; cell < count; cell++) {
    for (std::uint32_t i = 0; i < FAN_VERTICES; i++) {
      fans[cell].position[i] = positions[cell * FAN_VERTICES + i];
      fans[cell].ends[i] = ends[cell * FAN_VERTICES + i];
    }
    fans[cell].isClipped = modes[cell] != 0;
  }
  return fans;
}

TetMesh soup(const std::vector<glm::dvec3>& points) {
  TetMesh mesh;
  mesh.points = points;
  std::vector<double> scalars;
  for (std::uint32_t i = 0; i < points.size(); i++) {
    if (i % 4 == 0) mesh.cells.push_back({i, i + 1, i + 2, i + 3});
    scalars.push_back(std::sin(i * 1.7));
  }
  mesh.pointArrays.push_back({"s", 1, scalars});
  return mesh;
}

const TransferFunction& anyTransfer() {
  static const TransferFunction transfer({{0, {1, 1, 1}, 1}}, "t");
  return transfer;
}

double triangleArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// A ray's part in a cell, in mesh units and normalised scalars.
struct DeviceSegment {
  double thickness = 0.0;
  double sFront = 0.0;
  double sBack = 0.0;
  double tolerance = 0.0;  // of these, by how much the rounding of corners or planes is magnified
};

// Corners are rounded to 1e-7 of the image, planes to 1e-7 of the mesh; cells are about as large as the mesh.
double toleranceOf(double condition) { return 2e-6 + 4e-7 * condition; }

// What the fan says about a point of the image, by linear interpolation over the triangle that holds it.
std::optional<DeviceSegment> fanSegment(const Fan& fan, const glm::dvec2& ndc, bool isPerspective) {
  for (std::uint32_t k = 0; k < 4; k++) {
    const std::array<std::uint32_t, 3> t = {0, 1 + k, 1 + (k + 1) % 4};
    const auto corner = [&](std::uint32_t i) { return glm::dvec2(fan.position[t[i]]); };
    const double area = triangleArea(corner(0), corner(1), corner(2));
    if (std::abs(area) < 1e-9) continue;
    const glm::dvec3 w(triangleArea(ndc, corner(1), corner(2)) / area, triangleArea(corner(0), ndc, corner(2)) / area,
                       triangleArea(corner(0), corner(1), ndc) / area);
    if (w.x < 0 || w.y < 0 || w.z < 0) continue;
    const double longest = std::max(
        {glm::length(corner(1) - corner(0)), glm::length(corner(2) - corner(0)), glm::length(corner(2) - corner(1))});
    glm::dvec4 ends(0);
    for (std::uint32_t i = 0; i < 3; i++) ends += w[static_cast<int>(i)] * glm::dvec4(fan.ends[t[i]]);
    const double depthFront = isPerspective ? 1 / ends.x : 1;
    const double depthBack = isPerspective ? 1 / (ends.x - ends.z) : 1;
    return DeviceSegment{isPerspective ? depthBack - depthFront : ends.z, ends.y * depthFront, ends.w * depthBack,
                         toleranceOf(longest / std::abs(area))};
  }
  return std::nullopt;
}

// What the planes say about a ray, as the fragment shader asks them.
//   screen   units of x/z or x in mesh space
std::optional<DeviceSegment> clippedSegment(const Fan& fan, const glm::dvec2& screen, bool isPerspective) {
  const glm::dvec3 origin = isPerspective ? glm::dvec3(0) : glm::dvec3(screen, 0);
  const glm::dvec3 direction = isPerspective ? glm::dvec3(screen, 1) : glm::dvec3(0, 0, 1);
  const glm::dvec3 vertex0(fan.ends[1].w, fan.ends[2].w, fan.ends[3].w);
  double front = 0, back = 1e30;
  double condition = 0;
  glm::dvec4 offset, slope;
  for (int i = 0; i < 4; i++) {
    const glm::dvec4 plane(fan.ends[static_cast<size_t>(i)]);
    offset[i] = glm::dot(glm::dvec3(plane), origin - vertex0) + (i == 0 ? plane.w : 0.0);
    slope[i] = glm::dot(glm::dvec3(plane), direction);
    if (slope[i] > 0) front = std::max(front, -offset[i] / slope[i]);
    if (slope[i] < 0) back = std::min(back, -offset[i] / slope[i]);
    if (slope[i] == 0 && offset[i] <= 0) back = -1;
  }
  if (back <= front) return std::nullopt;
  for (int i = 0; i < 4; i++) {
    const double depth = -offset[i] / slope[i];
    if (depth == front || depth == back) condition = std::max(condition, (1 + back) / std::abs(slope[i]));
  }
  const glm::dvec4 scalar(fan.ends[4]);
  const auto scalarAt = [&](double depth) {
    const glm::dvec4 weight = glm::max(offset + slope * depth, glm::dvec4(0));
    return glm::dot(weight, scalar) / glm::dot(weight, glm::dvec4(1));
  };
  return DeviceSegment{back - front, scalarAt(front), scalarAt(back), toleranceOf(condition)};
}

// Segment of a ray by the double-precision caster and by the device.
void expectSameSegments(PassScene& scene, const std::vector<Fan>& fans, int raysPerCell) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  const MeshSpace& space = scene.gpuMesh.space();
  int compared = 0;
  for (size_t cell = 0; cell < fans.size(); cell++) {
    const CellVertices& v = scene.mesh.cells[cell];
    std::array<glm::dvec3, 4> corners;
    std::array<double, 4> scalars;
    for (size_t i = 0; i < 4; i++) {
      corners[i] = scene.mesh.point(v[i]);
      scalars[i] = scene.field.values[v[i]];
    }
    const reference::CellGeometry geometry(corners, scalars);
    for (int r = 0; r < raysPerCell; r++) {
      glm::dvec4 w(uniform(random), uniform(random), uniform(random), uniform(random));
      w /= w.x + w.y + w.z + w.w;
      const glm::dvec3 inside = w.x * corners[0] + w.y * corners[1] + w.z * corners[2] + w.w * corners[3];
      const glm::dvec4 clip = scene.camera.clipFromWorld(scene.size) * glm::dvec4(inside, 1);
      const glm::dvec2 ndc(clip.x / clip.w, clip.y / clip.w);
      const glm::dvec2 screen =
          ndc * glm::dvec2(scene.setup.view.halfSize) / glm::dvec2(scene.setup.view.pixelsPerUnit);
      const bool isPerspective = scene.setup.perspective;
      const auto actual = fans[cell].isClipped ? clippedSegment(fans[cell], screen, isPerspective)
                                               : fanSegment(fans[cell], ndc, isPerspective);
      if (geometry.empty()) {
        EXPECT_LE(actual.value_or(DeviceSegment{}).thickness, 1e-6) << "cell " << cell << " has no volume";
        continue;
      }
      const Ray ray = scene.camera.pixelRay(scene.size, (ndc.x + 1) * 0.5 * scene.size.width - 0.5,
                                            (1 - ndc.y) * 0.5 * scene.size.height - 0.5);
      reference::CellSegment expected;
      if (!actual || !geometry.intersect(ray, expected)) continue;
      EXPECT_NEAR(actual->thickness, (expected.back - expected.front) / space.scale, actual->tolerance)
          << "cell " << cell;
      EXPECT_NEAR(actual->sFront, (expected.sFront - space.scalarCenter) / space.scalarRange, actual->tolerance);
      EXPECT_NEAR(actual->sBack, (expected.sBack - space.scalarCenter) / space.scalarRange, actual->tolerance);
      compared++;
    }
  }
  EXPECT_GT(compared, static_cast<int>(fans.size()));
}

TEST_F(GpuTest, ProjectGivesEveryRaysSegmentOfRandomCells) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 4 * 500; i++) points.emplace_back(uniform(random), uniform(random), uniform(random));
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    Camera camera;
    camera.projection = projection;
    camera.eye = {1, -4, 2};
    camera.center = {0.1, 0, 0};
    camera.heightWorld = 4;
    camera.fovyDegrees = 60;
    PassScene scene(context(), soup(points), anyTransfer(), camera, {100, 80});
    expectSameSegments(scene, projectAll(scene), 20);
  }
}

// Small whole numbers seen along an axis: all fifty signs of the truth table occur exactly. Where one of them is zero,
// a face is seen edge-on, and the cell is clipped instead of projected.
TEST_F(GpuTest, ProjectHandlesAllDegenerateProjections) {
  std::mt19937 random(6);
  std::uniform_int_distribution<int> coordinate(0, 4);
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 4 * 20000; i++)
    points.emplace_back(coordinate(random) - 2, coordinate(random) - 2, coordinate(random) - 2);
  Camera camera;
  camera.projection = Projection::Orthographic;
  camera.eye = {0, -8, 0};
  camera.center = {0, 0, 0};
  camera.heightWorld = 8;  // a power of two: screen coordinates are exact
  PassScene scene(context(), soup(points), anyTransfer(), camera, {64, 64});
  const std::vector<Fan> fans = projectAll(scene);

  const auto table = makeTruthTable();
  std::array<int, 81> seen{};
  std::uint64_t triangles = 0;
  for (size_t cell = 0; cell < fans.size(); cell++) {
    std::array<glm::dvec2, 4> p;
    std::array<double, 4> depth;
    for (size_t i = 0; i < 4; i++) {
      const glm::dvec3 q = points[4 * cell + i];
      p[i] = {q.x, q.z};
      depth[i] = q.y;
    }
    const std::array<double, 4> area = {triangleArea(p[1], p[2], p[3]), -triangleArea(p[0], p[2], p[3]),
                                        triangleArea(p[0], p[1], p[3]), -triangleArea(p[0], p[1], p[2])};
    std::uint32_t index = 0;
    double positive = 0;
    double thickness = 0;  // at the thick vertex
    for (size_t i = 0; i < 4; i++) {
      index = index * 3 + (area[i] > 0 ? 2u : area[i] < 0 ? 0u : 1u);
      positive += std::max(area[i], 0.0);
      thickness += area[i] * depth[i];
    }
    seen[index]++;
    const bool isEdgeOn = std::count(area.begin(), area.end(), 0.0) > 0;
    // Heights are above a pixel or zero. Cells without a thickness have no light either, whatever draws them.
    if (thickness != 0.0) {
      EXPECT_EQ(fans[cell].isClipped, isEdgeOn);
    }
    triangles += fans[cell].isClipped ? 4 : shared::truthTriangles(table[index]);
    double covered = 0;
    for (std::uint32_t k = 0; k < 4; k++)
      covered += std::abs(triangleArea(glm::dvec2(fans[cell].position[0]), glm::dvec2(fans[cell].position[1 + k]),
                                       glm::dvec2(fans[cell].position[1 + (k + 1) % 4])));
    covered *= 16;  // ndc units are a quarter of the world's
    if (fans[cell].isClipped) {
      EXPECT_GE(covered, positive);
      continue;
    }
    EXPECT_NEAR(covered, positive, 1e-4);
    if (positive > 0) {
      EXPECT_NEAR(static_cast<double>(fans[cell].ends[0].z) * scene.gpuMesh.space().scale,
                  std::abs(thickness) / positive, 1e-5);
    }
  }
  EXPECT_EQ(std::count_if(seen.begin(), seen.end(), [](int n) { return n > 0; }), 51) << "fifty and no area at all";
  EXPECT_EQ(scene.counters().triangles, triangles);
  expectSameSegments(scene, fans, 2);
}

TEST_F(GpuTest, ProjectKeepsTheDigitsOfThinCellsFarAway) {
  // A sliver of height 1e-5 of its width, 1000 widths away: its thickness is far below the rounding of its depth.
  const double height = 1e-5;
  Camera camera;
  camera.eye = {0.3, 0.3, -1000};
  camera.center = {0.3, 0.3, 0};
  camera.up = {0, 1, 0};
  camera.fovyDegrees = 0.1;
  PassScene scene(context(), soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, height}}), anyTransfer(), camera,
                  {64, 64});
  const Fan fan = projectAll(scene)[0];
  const double qFront = static_cast<double>(fan.ends[0].x);
  const double dq = static_cast<double>(fan.ends[0].z);
  const double thickness = dq / (qFront * (qFront - dq)) * scene.gpuMesh.space().scale;
  EXPECT_NEAR(thickness / height, 1.0, 1e-3);
}

}  // namespace
}  // namespace tetralux::render
