#include "mesh/mesh_stats.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/parallel.h"
#include "mesh/mesh_stats_faces.h"

namespace tetralux {
namespace {

// Cells, or tuples of an array, that one thread takes at once. Results of such chunks are joined in ascending order, so
// that a sum does not depend on the number of threads.
constexpr size_t kChunk = 1 << 14;

template <typename Result, typename Body>
Result joinChunks(size_t count, const Body& body) {
  std::vector<Result> results((count + kChunk - 1) / kChunk);
  parallelFor(count, kChunk, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++) body(i, results[begin / kChunk]);
  });
  Result joined;
  for (const Result& result : results) joined.join(result);
  return joined;
}

// The square of a length below 1e-150 or above 1e150 leaves the range of double; std::hypot takes ten times as long.
double lengthOf(const glm::dvec3& v) {
  const double square = glm::dot(v, v);
  if (square > 1e-290 && square < 1e290) return std::sqrt(square);
  return std::hypot(v.x, v.y, v.z);
}

// Six times the signed volume, positive by VTK_TETRA's order: the fourth vertex is on the side that the first three,
// counterclockwise, show their front to.
double determinant(const glm::dvec3 (&p)[4]) {
  // Where two vertices coincide the terms cancel, but for rounding errors.
  for (int a = 0; a < 3; a++) {
    for (int b = a + 1; b < 4; b++) {
      if (p[a] == p[b]) return 0.0;
    }
  }
  return glm::dot(glm::cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
}

struct CellStats {
  double shortestEdge = std::numeric_limits<double>::infinity();
  double longestEdge = 0.0;
  double sixfoldVolume = 0.0;
  std::uint64_t zeroVolume = 0;
  std::uint64_t repeatedVertex = 0;
  std::uint64_t inverted = 0;

  void add(const glm::dvec3 (&p)[4], const CellVertices& vertices) {
    for (int a = 0; a < 3; a++) {
      for (int b = a + 1; b < 4; b++) {
        const double length = lengthOf(p[b] - p[a]);
        if (length > 0.0) shortestEdge = std::min(shortestEdge, length);
        longestEdge = std::max(longestEdge, length);
      }
    }
    const double volume = determinant(p);
    sixfoldVolume += std::abs(volume);
    zeroVolume += volume == 0.0;
    inverted += volume < 0.0;
    repeatedVertex += hasRepeatedVertex(sortedVertices(vertices));
  }

  void join(const CellStats& other) {
    shortestEdge = std::min(shortestEdge, other.shortestEdge);
    longestEdge = std::max(longestEdge, other.longestEdge);
    sixfoldVolume += other.sixfoldVolume;
    zeroVolume += other.zeroVolume;
    repeatedVertex += other.repeatedVertex;
    inverted += other.inverted;
  }
};

template <typename Point>
CellStats cellStats(const std::vector<CellVertices>& cells, const std::vector<Point>& points) {
  return joinChunks<CellStats>(cells.size(), [&](size_t i, CellStats& stats) {
    const CellVertices& v = cells[i];
    const glm::dvec3 p[4] = {glm::dvec3(points[v[0]]), glm::dvec3(points[v[1]]), glm::dvec3(points[v[2]]),
                             glm::dvec3(points[v[3]])};
    stats.add(p, v);
  });
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  std::uint64_t nonFinite = 0;

  void add(double value) {
    if (!std::isfinite(value)) {
      nonFinite++;
      return;
    }
    low = std::min(low, value);
    high = std::max(high, value);
  }

  void join(const Range& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
    nonFinite += other.nonFinite;
  }
};

template <typename T>
Range rangeOf(const std::vector<T>& values, size_t components) {
  return joinChunks<Range>(values.size() / components, [&](size_t tuple, Range& range) {
    const T* numbers = &values[tuple * components];
    if (components == 1) return range.add(static_cast<double>(numbers[0]));
    double length = 0.0;
    bool finite = true;
    for (size_t c = 0; c < components; c++) {
      const double number = static_cast<double>(numbers[c]);
      finite = finite && std::isfinite(number);
      length = std::hypot(length, number);
    }
    range.add(finite ? length : std::numeric_limits<double>::quiet_NaN());
  });
}

ArrayStats arrayStats(const DataArray& array, FieldAssociation association) {
  const Range range = std::visit([&](const auto& v) { return rangeOf(v, array.components); }, array.values);
  ArrayStats stats{array.name, array.typeName(), array.components, association, 0.0, 0.0, range.nonFinite};
  if (range.low <= range.high) {
    stats.low = range.low;
    stats.high = range.high;
  }
  return stats;
}

std::uint64_t countUnusedPoints(const std::vector<CellVertices>& cells, size_t pointCount) {
  std::vector<bool> used(pointCount);
  for (const CellVertices& cell : cells) {
    for (const std::uint32_t vertex : cell) used[vertex] = true;
  }
  return static_cast<std::uint64_t>(std::count(used.begin(), used.end(), false));
}

}  // namespace

MeshStats computeMeshStats(const TetMesh& mesh) {
  MeshStats stats;
  stats.points = mesh.pointCount();
  stats.cells = mesh.cellCount();
  stats.bounds = mesh.bounds();
  stats.unusedPoints = countUnusedPoints(mesh.cells, mesh.pointCount());
  for (const DataArray& a : mesh.pointArrays) stats.arrays.push_back(arrayStats(a, FieldAssociation::Point));
  for (const DataArray& a : mesh.cellArrays) stats.arrays.push_back(arrayStats(a, FieldAssociation::Cell));

  const CellStats cells = std::visit([&](const auto& points) { return cellStats(mesh.cells, points); }, mesh.points);
  if (cells.longestEdge > 0.0) stats.shortestEdge = cells.shortestEdge;
  stats.longestEdge = cells.longestEdge;
  stats.totalVolume = cells.sixfoldVolume / 6.0;
  stats.zeroVolumeCells = cells.zeroVolume;
  stats.repeatedVertexCells = cells.repeatedVertex;
  stats.invertedCells = cells.inverted;
  stats.duplicateCells = countDuplicateCells(mesh.cells, mesh.pointCount());

  const FaceCounts faces = countFaces(mesh.cells, mesh.pointCount());
  stats.boundaryFaces = faces.boundary;
  stats.interiorFaces = faces.interior;
  stats.overusedFaces = faces.overused;
  return stats;
}

}  // namespace tetralux
