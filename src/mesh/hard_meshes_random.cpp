#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/check.h"
#include "mesh/delaunay.h"
#include "mesh/hard_meshes.h"
#include "mesh/random.h"

namespace tetralux {
namespace {

// The number of points inside an edge of each axis, for a box of `points` points in all: as in a grid of that many,
// (x + 2)(y + 2)(z + 2) = points, with the same spacing along all axes.
glm::dvec3 pointsInsideEdges(double points, const glm::dvec3& extent) {
  constexpr int kHalvings = 60;  // of the spacing's logarithm: to rounding
  double low = 1e-6 * std::min({extent.x, extent.y, extent.z});
  double high = 2.0 * std::max({extent.x, extent.y, extent.z});
  for (int i = 0; i < kHalvings; i++) {
    const double middle = std::sqrt(low * high);
    const glm::dvec3 perEdge = extent / middle + 1.0;
    (perEdge.x * perEdge.y * perEdge.z > points ? low : high) = middle;
  }
  const glm::dvec3 inside = extent / high - 1.0;
  return {std::max(0.0, inside.x), std::max(0.0, inside.y), std::max(0.0, inside.z)};
}

// Random points in a box, triangulated. Corners, edges and sides have points of their own, about as dense as the
// inside: without them the sides would be a few large cells, which no deformation could follow.
TetMesh randomBox(std::uint32_t points, std::uint32_t seed, const glm::dvec3& low, const glm::dvec3& high) {
  constexpr std::uint32_t kCorners = 8;
  CHECK_LE(kCorners, points);
  const glm::dvec3 insideEdge = pointsInsideEdges(points, high - low);
  std::vector<glm::dvec3> positions;
  positions.reserve(points);
  std::uint64_t randomIndex = 0;
  // `count` points, at random along the axes whose bit in `freeAxes` is set, else at the lower or upper end by `upper`.
  const auto add = [&](double count, int freeAxes, int upper) {
    for (double i = 1.0; i <= count && positions.size() < points; i += 1.0) {
      glm::dvec3 p;
      for (int axis = 0; axis < 3; axis++) {
        const double end = upper >> axis & 1 ? high[axis] : low[axis];
        const bool random = (freeAxes >> axis & 1) != 0;
        p[axis] = random ? low[axis] + (high[axis] - low[axis]) * randomUnit(seed, randomIndex++) : end;
      }
      positions.push_back(p);
    }
  };
  for (int freeAxes = 0; freeAxes < 7; freeAxes++) {
    double count = 1.0;
    for (int axis = 0; axis < 3; axis++) count *= freeAxes >> axis & 1 ? insideEdge[axis] : 1.0;
    for (int upper = 0; upper < 8; upper++) {
      if ((upper & freeAxes) == 0) add(std::round(count), freeAxes, upper);
    }
  }
  add(points, 7, 0);
  return delaunay(sortedAlongCurve(positions));
}

std::vector<glm::dvec3>& pointsOf(TetMesh& mesh) { return std::get<std::vector<glm::dvec3>>(mesh.points); }

}  // namespace

TetMesh randomDelaunay(std::uint32_t points, std::uint32_t seed, const FieldFunction& field) {
  TetMesh mesh = randomBox(points, seed, glm::dvec3(0.0), glm::dvec3(1.0));
  addPreferredField(mesh, "scalar", field);
  return mesh;
}

TetMesh flattenedDelaunay(std::uint32_t points, std::uint32_t seed, double factor, const FieldFunction& field) {
  CHECK_LT(0.0, factor);
  TetMesh mesh = randomBox(points, seed, glm::dvec3(0.0), glm::dvec3(1.0));
  for (glm::dvec3& p : pointsOf(mesh)) p.z *= factor;
  addPreferredField(mesh, "scalar", field);
  return mesh;
}

TetMesh twistedDelaunay(std::uint32_t points, std::uint32_t seed, double turns, const FieldFunction& field) {
  constexpr double kHeight = 3.0;
  CHECK(std::isfinite(turns));
  TetMesh mesh = randomBox(points, seed, {-0.5, -0.5, 0.0}, {0.5, 0.5, kHeight});
  for (glm::dvec3& p : pointsOf(mesh)) {
    const double angle = 2.0 * std::numbers::pi * turns * p.z / kHeight;
    p = {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y, p.z};
  }
  addPreferredField(mesh, "scalar", field);
  return mesh;
}

}  // namespace tetralux
