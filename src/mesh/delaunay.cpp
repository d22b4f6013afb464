#include "mesh/delaunay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/check.h"
#include "mesh/delaunay_cells.h"
#include "mesh/delaunay_order.h"
#include "mesh/delaunay_predicates.h"

namespace tetralux {
namespace {

// The grid of a point set: places are (origin + GridPoint) * step. Step is a power of two and every product is below
// 2^52 steps, so that places are exact in double precision and what the predicates prove holds for them.
struct Grid {
  double step = 0.0;
  glm::dvec3 origin{0.0};  // whole numbers, in steps

  // floor(x + 1/2), not round(): it rounds all along the axis alike, so distances never grow by more than a step.
  static glm::dvec3 nearest(const glm::dvec3& steps) {
    return {std::floor(steps.x + 0.5), std::floor(steps.y + 0.5), std::floor(steps.z + 0.5)};
  }

  GridPoint toGrid(const glm::dvec3& position) const {
    const glm::dvec3 p = nearest(position / step) - origin;
    return {static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y), static_cast<std::int32_t>(p.z)};
  }

  glm::dvec3 toWorld(const GridPoint& p) const { return (origin + glm::dvec3(p.x, p.y, p.z)) * step; }
};

double largestComponent(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

Grid gridOf(const std::vector<glm::dvec3>& positions) {
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(std::numeric_limits<double>::lowest());
  for (const glm::dvec3& p : positions) {
    CHECK(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    for (int axis = 0; axis < 3; axis++) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  constexpr int kExactBits = 51;  // of a coordinate in steps: one less than 52 leaves the half that nearest() adds
  int extentExponent = 0;
  int offsetExponent = 0;
  const double extent = largestComponent(high - low);
  CHECK(std::isfinite(extent));
  std::frexp(extent, &extentExponent);  // extent < 2^exponent
  std::frexp(std::max(largestComponent(high), -std::min({low.x, low.y, low.z})), &offsetExponent);
  Grid grid;
  grid.step = std::ldexp(1.0, std::max(extentExponent - 21, offsetExponent - kExactBits));
  while (largestComponent(Grid::nearest(high / grid.step) - Grid::nearest(low / grid.step)) > kGridSize)
    grid.step *= 2.0;
  grid.origin = Grid::nearest(low / grid.step);
  return grid;
}

std::vector<GridPoint> toGrid(const Grid& grid, const std::vector<glm::dvec3>& positions) {
  std::vector<GridPoint> points(positions.size());
  std::transform(positions.begin(), positions.end(), points.begin(), [&](const auto& p) { return grid.toGrid(p); });
  return points;
}

// The smallest vertex first, then the smallest of the others: an even permutation, which keeps the volume positive.
CellVertices canonical(CellVertices v) {
  const auto smallest = std::min_element(v.begin(), v.end());
  if (smallest != v.begin()) {
    std::swap(v[0], *smallest);
    std::swap(v[2], v[3]);
  }
  std::rotate(v.begin() + 1, std::min_element(v.begin() + 1, v.end()), v.end());
  return v;
}

// Sorts cells: by counting on the first vertex, which does nearly all of it in two passes, then by comparing.
std::vector<CellVertices> sortedCells(const std::vector<CellVertices>& cells, size_t points) {
  std::vector<size_t> end(points + 1);
  for (const CellVertices& cell : cells) end[cell[0] + 1]++;
  for (size_t i = 0; i < points; i++) end[i + 1] += end[i];
  std::vector<CellVertices> sorted(cells.size());
  for (const CellVertices& cell : cells) sorted[end[cell[0]]++] = cell;
  size_t begin = 0;
  for (size_t i = 0; i < points; i++) {
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin),
              sorted.begin() + static_cast<std::ptrdiff_t>(end[i]));
    begin = end[i];
  }
  return sorted;
}

}  // namespace

TetMesh delaunay(const std::vector<glm::dvec3>& positions) {
  CHECK_LE(size_t{4}, positions.size());
  CHECK_LT(positions.size(), size_t{1} << 31);
  const Grid grid = gridOf(positions);
  std::vector<GridPoint> points = toGrid(grid, positions);
  const std::vector<std::uint32_t> order = insertionOrder(points);

  // The triangulation runs on points stored in the order of insertion, where those that it needs together are near.
  std::vector<GridPoint> inserted(order.size());
  std::transform(order.begin(), order.end(), inserted.begin(), [&](std::uint32_t i) { return points[i]; });
  std::vector<CellVertices> cells = delaunayCells(inserted);

  // Back to the order given, without the points that were dropped.
  constexpr std::uint32_t kDropped = 0xffffffff;
  std::vector<std::uint32_t> newNumber(points.size(), kDropped);
  for (const std::uint32_t i : order) newNumber[i] = 0;
  std::vector<glm::dvec3> world;
  world.reserve(order.size());
  for (size_t i = 0; i < points.size(); i++) {
    if (newNumber[i] == kDropped) continue;
    newNumber[i] = static_cast<std::uint32_t>(world.size());
    world.push_back(grid.toWorld(points[i]));
  }
  for (CellVertices& cell : cells) {
    for (std::uint32_t& vertex : cell) vertex = newNumber[order[vertex]];
    cell = canonical(cell);
  }
  TetMesh mesh;
  mesh.cells = sortedCells(cells, world.size());
  mesh.points = std::move(world);
  return mesh;
}

std::vector<glm::dvec3> sortedAlongCurve(const std::vector<glm::dvec3>& positions) {
  if (positions.empty()) return {};
  const std::vector<GridPoint> points = toGrid(gridOf(positions), positions);
  std::vector<std::pair<std::uint64_t, size_t>> curve(points.size());
  for (size_t i = 0; i < points.size(); i++) curve[i] = {hilbertIndex(points[i]), i};
  std::sort(curve.begin(), curve.end());
  std::vector<glm::dvec3> sorted(positions.size());
  std::transform(curve.begin(), curve.end(), sorted.begin(),
                 [&](const auto& entry) { return positions[entry.second]; });
  return sorted;
}

}  // namespace tetralux
