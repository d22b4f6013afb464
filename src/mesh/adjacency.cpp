#include "mesh/adjacency.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/check.h"
#include "mesh/orientation.h"
#include "mesh/vertex_buckets.h"

namespace tetralux {
namespace {

constexpr size_t kGrain = 1 << 14;

// A face in the bucket of its smallest vertex: the other two, and whose it is.
struct FaceKey {
  std::uint32_t middle, last;
  std::uint32_t cellFace;  // 4 cell + face

  bool sameFace(const FaceKey& other) const { return middle == other.middle && last == other.last; }
  auto operator<=>(const FaceKey&) const = default;
};

// The vertices of face k of a cell, ascending.
std::array<std::uint32_t, 3> faceVertices(const CellVertices& sorted, std::uint32_t k) {
  std::array<std::uint32_t, 3> face;
  size_t next = 0;
  for (std::uint32_t i = 0; i < 4; i++) {
    if (i != k) face[next++] = sorted[i];
  }
  return face;
}

// A cell that is there twice lies behind none of its faces: each of the two has its own boundary.
bool areEqualCells(const TetMesh& mesh, std::uint32_t a, std::uint32_t b) {
  return sortedVertices(mesh.cells[a]) == sortedVertices(mesh.cells[b]);
}

void linkNeighbors(const TetMesh& mesh, Adjacency& adjacency) {
  auto buckets =
      VertexBuckets<FaceKey>::dealOut(mesh.cellCount(), mesh.pointCount(), [&](size_t cell, const auto& emit) {
        const CellVertices v = sortedVertices(mesh.cells[cell]);
        if (hasRepeatedVertex(v)) return;
        for (std::uint32_t k = 0; k < 4; k++) {
          const auto face = faceVertices(v, k);
          emit(face[0], FaceKey{face[1], face[2], static_cast<std::uint32_t>(4 * cell + k)});
        }
      });
  adjacency.neighbors.assign(mesh.cellCount(), {kNoCell, kNoCell, kNoCell, kNoCell});
  parallelFor(mesh.pointCount(), kGrain, [&](size_t begin, size_t end, unsigned) {
    for (size_t point = begin; point < end; point++) {
      const auto keys = buckets.of(point);
      std::sort(keys.begin(), keys.end());
      for (size_t i = 0; i < keys.size();) {
        size_t next = i + 1;
        while (next < keys.size() && keys[next].sameFace(keys[i])) next++;
        if (next - i == 2 && !areEqualCells(mesh, keys[i].cellFace / 4, keys[i + 1].cellFace / 4)) {
          const std::uint32_t a = keys[i].cellFace;
          const std::uint32_t b = keys[i + 1].cellFace;
          adjacency.neighbors[a / 4][a % 4] = b / 4;
          adjacency.neighbors[b / 4][b % 4] = a / 4;
        }
        i = next;
      }
    }
  });
}

// Sides of all four faces from the sign of the cell's volume with its vertices in ascending order: moving vertex k to
// the end takes 3 - k exchanges.
std::uint8_t sidesOf(int volumeSign) { return volumeSign > 0 ? 0b1010 : 0b0101; }

bool isPositive(std::uint8_t sides, std::uint32_t face) { return (sides >> face & 1) != 0; }

// The face of `cell` behind which `neighbor` lies.
std::uint32_t faceTowards(const Adjacency& adjacency, std::uint32_t cell, std::uint32_t neighbor) {
  const auto& n = adjacency.neighbors[cell];
  return static_cast<std::uint32_t>(std::find(n.begin(), n.end(), neighbor) - n.begin());
}

// Flat cells take the orientation that puts them across from a neighbour that has one, nearest ones first.
void orientFlatCells(Adjacency& adjacency, std::vector<std::uint32_t> flat, std::vector<bool>& isFlat) {
  while (!flat.empty()) {
    std::vector<std::uint32_t> rest;
    std::vector<std::uint32_t> done;
    for (const std::uint32_t cell : flat) {
      bool found = false;
      for (std::uint32_t k = 0; k < 4 && !found; k++) {
        const std::uint32_t neighbor = adjacency.neighbors[cell][k];
        if (neighbor == kNoCell || isFlat[neighbor]) continue;
        const bool across = isPositive(adjacency.sides[neighbor], faceTowards(adjacency, neighbor, cell));
        adjacency.sides[cell] = sidesOf(isPositive(sidesOf(1), k) != across ? 1 : -1);
        found = true;
      }
      (found ? done : rest).push_back(cell);
    }
    if (done.empty()) return;  // an island of flat cells: it covers no ray
    for (const std::uint32_t cell : done) isFlat[cell] = false;
    flat = std::move(rest);
  }
}

void findSides(const TetMesh& mesh, Adjacency& adjacency) {
  const size_t cellCount = mesh.cellCount();
  adjacency.sides.resize(cellCount);
  std::vector<std::int8_t> volumeSign(cellCount);
  parallelFor(cellCount, kGrain, [&](size_t begin, size_t end, unsigned) {
    for (size_t cell = begin; cell < end; cell++) {
      const CellVertices v = sortedVertices(mesh.cells[cell]);
      volumeSign[cell] = static_cast<std::int8_t>(
          orientationSign(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3])));
      adjacency.sides[cell] = sidesOf(volumeSign[cell]);
    }
  });
  std::vector<std::uint32_t> flat;
  std::vector<bool> isFlat(cellCount, false);
  for (std::uint32_t cell = 0; cell < cellCount; cell++) {
    if (volumeSign[cell] != 0) continue;
    flat.push_back(cell);
    isFlat[cell] = true;
  }
  orientFlatCells(adjacency, std::move(flat), isFlat);

  std::atomic<std::uint64_t> folded{0};
  parallelFor(cellCount, kGrain, [&](size_t begin, size_t end, unsigned) {
    for (size_t cell = begin; cell < end; cell++) {
      for (std::uint32_t k = 0; k < 4; k++) {
        const std::uint32_t neighbor = adjacency.neighbors[cell][k];
        if (neighbor == kNoCell) continue;
        const std::uint32_t back = faceTowards(adjacency, neighbor, static_cast<std::uint32_t>(cell));
        const auto sides = [&](size_t i) {
          return std::atomic_ref(adjacency.sides[i]).load(std::memory_order_relaxed);
        };
        if (isPositive(sides(cell), k) != isPositive(sides(neighbor), back)) continue;
        // Other threads read this byte, but only its lower bits, which stay.
        std::atomic_ref(adjacency.sides[cell])
            .fetch_or(static_cast<std::uint8_t>(1u << (4 + k)), std::memory_order_relaxed);
        if (cell < neighbor) folded++;
      }
    }
  });
  adjacency.foldedFaces = folded;
}

void listBoundary(const TetMesh& mesh, Adjacency& adjacency) {
  for (std::uint32_t cell = 0; cell < mesh.cellCount(); cell++) {
    const CellVertices v = sortedVertices(mesh.cells[cell]);
    if (hasRepeatedVertex(v)) continue;
    for (std::uint32_t k = 0; k < 4; k++) {
      if (adjacency.neighbors[cell][k] != kNoCell) continue;
      auto face = faceVertices(v, k);
      if (isPositive(adjacency.sides[cell], k)) std::swap(face[1], face[2]);  // its normal pointed at the cell
      adjacency.boundary.push_back({face, cell});
    }
  }
}

// Of boundary faces that are one closed surface: whether no edge is concave.
bool isLocallyConvex(const TetMesh& mesh, const std::vector<BoundaryFace>& faces) {
  struct Edge {
    std::uint32_t low, high;
    std::uint32_t face;
    auto operator<=>(const Edge&) const = default;
  };
  std::vector<Edge> edges;
  edges.reserve(faces.size() * 3);
  for (std::uint32_t f = 0; f < faces.size(); f++) {
    for (size_t i = 0; i < 3; i++) {
      const auto [low, high] = std::minmax(faces[f].vertices[i], faces[f].vertices[(i + 1) % 3]);
      edges.push_back({low, high, f});
    }
  }
  std::sort(edges.begin(), edges.end());
  const double tolerance = 1e-9 * mesh.bounds().diagonal();
  std::vector<std::uint32_t> parent(faces.size());
  for (std::uint32_t f = 0; f < parent.size(); f++) parent[f] = f;
  const auto root = [&](std::uint32_t f) {
    while (parent[f] != f) f = parent[f] = parent[parent[f]];
    return f;
  };
  size_t components = faces.size();
  for (size_t i = 0; i < edges.size(); i += 2) {
    // Exactly two faces at every edge, otherwise the surface is not closed or touches itself.
    if (i + 1 == edges.size() || edges[i].low != edges[i + 1].low || edges[i].high != edges[i + 1].high) return false;
    if (i + 2 < edges.size() && edges[i + 2].low == edges[i].low && edges[i + 2].high == edges[i].high) return false;
    const BoundaryFace& face = faces[edges[i].face];
    const BoundaryFace& other = faces[edges[i + 1].face];
    const glm::dvec3 a = mesh.point(face.vertices[0]);
    const glm::dvec3 normal = glm::cross(mesh.point(face.vertices[1]) - a, mesh.point(face.vertices[2]) - a);
    const double length = glm::length(normal);
    for (const std::uint32_t vertex : other.vertices) {
      if (glm::dot(normal, mesh.point(vertex) - a) > tolerance * length) return false;
    }
    const std::uint32_t r0 = root(edges[i].face);
    const std::uint32_t r1 = root(edges[i + 1].face);
    if (r0 != r1) {
      parent[r0] = r1;
      components--;
    }
  }
  return components == 1;
}

}  // namespace

Adjacency makeAdjacency(const TetMesh& mesh) {
  CHECK_LT(mesh.cellCount(), size_t{1} << 30);  // a cell and its face share 32 bits
  Adjacency adjacency;
  linkNeighbors(mesh, adjacency);
  findSides(mesh, adjacency);
  listBoundary(mesh, adjacency);
  adjacency.isConvex = adjacency.foldedFaces == 0 && isLocallyConvex(mesh, adjacency.boundary);
  return adjacency;
}

}  // namespace tetralux
