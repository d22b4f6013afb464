#include "mesh/adjacency.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "base/check.h"
#include "mesh/boundary.h"
#include "mesh/link_neighbors.h"
#include "mesh/orientation.h"
#include "mesh/vertex_buckets.h"

namespace tetralux {
namespace {

constexpr size_t kCellsAtOnce = 1 << 14;

// Of a flat cell that has no sides yet: those of all others have two bits.
constexpr std::uint8_t kFlat = 0;

// Sides of all four faces from the sign of the cell's volume with its vertices in ascending order: moving vertex k to
// the end takes 3 - k exchanges.
std::uint8_t sidesOf(int volumeSign) { return volumeSign > 0 ? 0b1010 : 0b0101; }

bool isPositive(std::uint8_t sides, std::uint32_t face) { return (sides >> face & 1) != 0; }

std::uint8_t foldedBit(std::uint32_t face) { return static_cast<std::uint8_t>(1u << (4 + face)); }

// Sets all sides, and returns the flat cells, which have none yet, in ascending order.
std::vector<std::uint32_t> findSides(const TetMesh& mesh, Adjacency& adjacency) {
  adjacency.sides.resize(mesh.cellCount());
  std::vector<std::uint32_t> flat;
  std::mutex mutex;
  const auto findAll = [&](const auto& points) {
    parallelFor(mesh.cellCount(), kCellsAtOnce, [&](size_t begin, size_t end, unsigned) {
      for (size_t cell = begin; cell < end; cell++) {
        const CellVertices v = sortedVertices(mesh.cells[cell]);
        const auto point = [&](size_t i) { return glm::dvec3(points[v[i]]); };
        const int sign = orientationSign(point(0), point(1), point(2), point(3));
        adjacency.sides[cell] = sign == 0 ? kFlat : sidesOf(sign);
        if (sign != 0) continue;
        const std::lock_guard lock(mutex);
        flat.push_back(static_cast<std::uint32_t>(cell));
      }
    });
  };
  std::visit(findAll, mesh.points);
  std::sort(flat.begin(), flat.end());
  return flat;
}

// The face of `cell` behind which `neighbor` lies.
std::uint32_t faceTowards(const Adjacency& adjacency, std::uint32_t cell, std::uint32_t neighbor) {
  const auto& n = adjacency.neighbors[cell];
  return static_cast<std::uint32_t>(std::find(n.begin(), n.end(), neighbor) - n.begin());
}

// Flat cells take the orientation that puts them across from a neighbour that has one, nearest ones first.
void orientFlatCells(Adjacency& adjacency, std::vector<std::uint32_t> flat) {
  while (!flat.empty()) {
    std::vector<std::uint32_t> rest;
    std::vector<std::pair<std::uint32_t, std::uint8_t>> found;
    for (const std::uint32_t cell : flat) {
      const auto& neighbors = adjacency.neighbors[cell];
      const auto known = std::find_if(neighbors.begin(), neighbors.end(), [&](std::uint32_t neighbor) {
        return neighbor != kNoCell && adjacency.sides[neighbor] != kFlat;
      });
      if (known == neighbors.end()) {
        rest.push_back(cell);
        continue;
      }
      const auto k = static_cast<std::uint32_t>(known - neighbors.begin());
      const bool across = isPositive(adjacency.sides[*known], faceTowards(adjacency, *known, cell));
      found.emplace_back(cell, sidesOf(isPositive(sidesOf(1), k) != across ? 1 : -1));
    }
    // An island of flat cells: it covers no ray.
    if (found.empty()) {
      for (const std::uint32_t cell : rest) adjacency.sides[cell] = sidesOf(0);
      return;
    }
    for (const auto& [cell, sides] : found) adjacency.sides[cell] = sides;
    flat = std::move(rest);
  }
}

// Marks the shared faces of cells that were flat as folded where they are.
void foldFlatCells(Adjacency& adjacency, const std::vector<std::uint32_t>& flat) {
  for (const std::uint32_t cell : flat) {
    for (std::uint32_t k = 0; k < 4; k++) {
      const std::uint32_t neighbor = adjacency.neighbors[cell][k];
      if (neighbor == kNoCell) continue;
      const std::uint32_t back = faceTowards(adjacency, neighbor, cell);
      std::uint8_t& sides = adjacency.sides[cell];
      if (isPositive(sides, k) != isPositive(adjacency.sides[neighbor], back)) continue;
      if ((sides & foldedBit(k)) != 0) continue;  // seen from the neighbour, which was flat as well
      sides |= foldedBit(k);
      adjacency.sides[neighbor] |= foldedBit(back);
      adjacency.foldedFaces++;
    }
  }
}

}  // namespace

Adjacency makeAdjacency(const TetMesh& mesh) {
  CHECK_LT(mesh.cellCount(), size_t{1} << 30);  // a cell and its face share 32 bits
  Adjacency adjacency;
  const std::vector<std::uint32_t> flat = findSides(mesh, adjacency);
  std::atomic<std::uint64_t> folded{0};
  adjacency.neighbors = linkNeighbors(mesh, [&](std::uint32_t a, std::uint32_t b) {
    // Other threads may be setting upper bits of these bytes; the lower ones stay.
    const auto sides = [&](std::uint32_t cellFace) { return std::atomic_ref(adjacency.sides[cellFace / 4]); };
    const std::uint8_t sidesA = sides(a).load(std::memory_order_relaxed);
    const std::uint8_t sidesB = sides(b).load(std::memory_order_relaxed);
    const bool isFlat = (sidesA & 0xf) == kFlat || (sidesB & 0xf) == kFlat;
    if (isFlat || isPositive(sidesA, a % 4) != isPositive(sidesB, b % 4)) return;
    sides(a).fetch_or(foldedBit(a % 4), std::memory_order_relaxed);
    sides(b).fetch_or(foldedBit(b % 4), std::memory_order_relaxed);
    folded++;
  });
  adjacency.foldedFaces = folded;
  orientFlatCells(adjacency, flat);
  foldFlatCells(adjacency, flat);
  adjacency.boundary = listBoundary(mesh, adjacency);
  adjacency.isConvex = adjacency.foldedFaces == 0 && isConvexSurface(mesh, adjacency.boundary);
  return adjacency;
}

}  // namespace tetralux
