// Which vertices share a cell with a vertex.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tet_mesh.h"

namespace tetralux {

// Neighbours of every vertex, each once, in ascending order, without the vertex itself; none of a vertex without cells.
// Takes about 10 bytes per cell, and 16 more while it is made.
class VertexNeighbors {
 public:
  // Linear in the mesh; on all processors.
  explicit VertexNeighbors(const TetMesh& mesh);

  std::span<const std::uint32_t> of(size_t vertex) const {
    const Block& block = blocks_[vertex / kBlockSize];
    const size_t k = vertex % kBlockSize;
    const std::uint32_t begin = k == 0 ? 0 : block.ends[k - 1];
    return std::span(block.vertices).subspan(begin, block.ends[k] - begin);
  }

 private:
  // Vertices are dealt with in blocks of their own, so that no list needs to know the lengths of those before it.
  static constexpr size_t kBlockSize = 1 << 12;

  struct Block {
    std::vector<std::uint32_t> ends;  // in `vertices`, of each vertex's neighbours
    std::vector<std::uint32_t> vertices;
  };

  std::vector<Block> blocks_;
};

}  // namespace tetralux
