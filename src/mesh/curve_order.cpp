#include "mesh/curve_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/parallel.h"
#include "mesh/delaunay_order.h"
#include "mesh/random.h"

namespace tetralux {
namespace {

constexpr size_t kGrain = 1 << 14;
constexpr size_t kSampledCells = 1 << 16;

// old[i] is the number that what is number i from now on had before.
using Order = std::vector<std::uint32_t>;

template <typename T>
void reorder(std::vector<T>& values, const Order& old, size_t components) {
  std::vector<T> moved(values.size());
  parallelFor(old.size(), kGrain, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++)
      for (size_t c = 0; c < components; c++) moved[i * components + c] = values[old[i] * components + c];
  });
  values = std::move(moved);
}

void reorder(std::vector<DataArray>& arrays, const Order& old) {
  for (DataArray& array : arrays)
    std::visit([&](auto& values) { reorder(values, old, array.components); }, array.values);
}

void reorderPoints(TetMesh& mesh, const Order& old) {
  std::visit([&](auto& points) { reorder(points, old, 1); }, mesh.points);
  reorder(mesh.pointArrays, old);
  Order now(old.size());
  for (size_t i = 0; i < old.size(); i++) now[old[i]] = static_cast<std::uint32_t>(i);
  parallelFor(mesh.cells.size(), kGrain, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++)
      for (std::uint32_t& vertex : mesh.cells[i]) vertex = now[vertex];
  });
}

void reorderCells(TetMesh& mesh, const Order& old) {
  reorder(mesh.cells, old, 1);
  reorder(mesh.cellArrays, old);
}

std::uint32_t lowestVertex(const CellVertices& cell) { return *std::min_element(cell.begin(), cell.end()); }

// Stable, by counting.
Order byLowestVertex(const TetMesh& mesh) {
  std::vector<std::uint32_t> next(mesh.pointCount() + 1, 0);
  for (const CellVertices& cell : mesh.cells) next[lowestVertex(cell) + 1]++;
  std::partial_sum(next.begin(), next.end(), next.begin());
  Order order(mesh.cellCount());
  for (size_t i = 0; i < order.size(); i++) order[next[lowestVertex(mesh.cells[i])]++] = static_cast<std::uint32_t>(i);
  return order;
}

Order alongCurve(const TetMesh& mesh) {
  const Bounds bounds = mesh.bounds();
  const glm::dvec3 size = bounds.high - bounds.low;
  const double longest = std::max({size.x, size.y, size.z});
  const double scale = longest > 0.0 ? static_cast<double>(kGridSize) / longest : 0.0;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> curve(mesh.pointCount());
  parallelFor(curve.size(), kGrain, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++) {
      const glm::dvec3 place = (mesh.point(i) - bounds.low) * scale;
      const auto whole = [](double x) { return std::clamp(static_cast<std::int32_t>(x), 0, kGridSize); };
      curve[i] = {hilbertIndex({whole(place.x), whole(place.y), whole(place.z)}), static_cast<std::uint32_t>(i)};
    }
  });
  std::sort(curve.begin(), curve.end());
  Order order(curve.size());
  std::transform(curve.begin(), curve.end(), order.begin(), [](const auto& entry) { return entry.second; });
  return order;
}

Order randomOrder(size_t count, std::uint64_t seed) {
  Order order(count);
  std::iota(order.begin(), order.end(), 0u);
  for (size_t i = count; i > 1; i--)
    std::swap(order[i - 1], order[static_cast<size_t>(randomUnit(seed, i) * static_cast<double>(i))]);
  return order;
}

}  // namespace

double memorySpread(const TetMesh& mesh) {
  const size_t count = mesh.cellCount();
  if (count == 0) return 0.0;
  const size_t samples = std::min(count, kSampledCells);
  double withinCells = 0.0;
  double betweenCells = 0.0;
  for (size_t i = 0; i < samples; i++) {
    const size_t at = i * count / samples;
    const CellVertices& cell = mesh.cells[at];
    const auto [low, high] = std::minmax_element(cell.begin(), cell.end());
    withinCells += *high - *low;
    const CellVertices& next = mesh.cells[std::min(at + 1, count - 1)];
    betweenCells += std::abs(static_cast<double>(lowestVertex(next)) - static_cast<double>(*low));
  }
  return std::max(withinCells, betweenCells) / static_cast<double>(samples) / static_cast<double>(mesh.pointCount());
}

void orderAlongCurve(TetMesh& mesh) {
  reorderPoints(mesh, alongCurve(mesh));
  reorderCells(mesh, byLowestVertex(mesh));
}

void shuffle(TetMesh& mesh, std::uint64_t seed) {
  reorderPoints(mesh, randomOrder(mesh.pointCount(), seed));
  reorderCells(mesh, randomOrder(mesh.cellCount(), seed + 1));
}

}  // namespace tetralux
