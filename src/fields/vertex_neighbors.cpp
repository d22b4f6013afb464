#include "fields/vertex_neighbors.h"

#include <algorithm>

#include "base/parallel.h"
#include "mesh/vertex_buckets.h"

namespace tetralux {

VertexNeighbors::VertexNeighbors(const TetMesh& mesh) {
  const size_t points = mesh.pointCount();
  auto cellsAt = VertexBuckets<std::uint32_t>::dealOut(mesh.cellCount(), points, [&](size_t cell, const auto& emit) {
    for (const std::uint32_t vertex : mesh.cells[cell]) emit(vertex, static_cast<std::uint32_t>(cell));
  });
  blocks_.resize((points + kBlockSize - 1) / kBlockSize);
  parallelFor(points, kBlockSize, [&](size_t begin, size_t end, unsigned) {
    Block& block = blocks_[begin / kBlockSize];
    std::vector<std::uint32_t> found;
    for (size_t vertex = begin; vertex < end; vertex++) {
      found.clear();
      for (const std::uint32_t cell : cellsAt.of(vertex)) {
        for (const std::uint32_t other : mesh.cells[cell]) {
          if (other != vertex) found.push_back(other);
        }
      }
      std::sort(found.begin(), found.end());
      found.erase(std::unique(found.begin(), found.end()), found.end());
      block.vertices.insert(block.vertices.end(), found.begin(), found.end());
      block.ends.push_back(static_cast<std::uint32_t>(block.vertices.size()));
    }
    block.vertices.shrink_to_fit();
  });
}

}  // namespace tetralux
