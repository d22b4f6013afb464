// How rays get from cell to cell, on the device: what the march needs beside the mesh.
#pragma once

#include <cstdint>

#include "gpu/pieced_buffer.h"
#include "mesh/adjacency.h"

namespace tetralux::render {

// 32 bytes per cell and 16 per boundary face; of a whole mesh an eighth of a byte per cell more.
class WalkTopology {
 public:
  // Of a whole mesh.
  //   adjacency   without folds (mesh/cut_folds.h); neither it nor the mesh need outlive the call
  //   pieceBits   of across() (gpu/pieced_buffer.h); fewer for tests
  WalkTopology(const gpu::Context& context, const TetMesh& mesh, const Adjacency& adjacency,
               unsigned pieceBits = gpu::kPieceBits);
  // Room for that of a part of a mesh, which something on the device writes (skip_pass.h).
  //   cellCount   of the whole mesh: cells keep their numbers
  WalkTopology(const gpu::Context& context, std::uint32_t cellCount, std::uint32_t boundaryCount,
               unsigned pieceBits = gpu::kPieceBits);

  // Two uint per face of a cell, faces numbered as in Adjacency: the cell across it, or kNoCell, and that cell's vertex
  // opposite. The address is that of a table of pieces of whole cells.
  const gpu::TexelView& across() const { return acrossView_; }
  const gpu::PiecedBuffer& acrossBuffer() const { return acrossBuffer_; }
  unsigned pieceBits() const { return pieceBits_; }
  VkDeviceAddress acrossAddress() const { return acrossBuffer_.address(); }

  // Boundary faces: three vertices, (b - a) x (c - a) points outwards, and which face of which cell it is
  // (include/ray_walk.glsl).
  const gpu::TexelView& boundary() const { return boundaryView_; }
  const gpu::Buffer& boundaryBuffer() const { return boundaryBuffer_; }
  VkDeviceAddress boundaryAddress() const { return boundaryBuffer_.address(); }
  std::uint32_t boundaryCount() const { return boundaryCount_; }

  // A bit per cell, in uint: it lies on the positive side of its faces 1 and 3 (Adjacency::sides), and so on the other
  // of 0 and 2. Only of a whole mesh.
  const gpu::TexelView& windings() const { return windingView_; }

  std::uint64_t sizeBytes() const;
  // What a part of a mesh takes.
  static std::uint64_t bytesFor(std::uint64_t cellCount, std::uint64_t boundaryCount) {
    return 32 * cellCount + 16 * boundaryCount;
  }

 private:
  std::uint32_t boundaryCount_;
  unsigned pieceBits_;
  gpu::PiecedBuffer acrossBuffer_;
  gpu::Buffer boundaryBuffer_;
  gpu::Buffer windingBuffer_;
  gpu::TexelView acrossView_;
  gpu::TexelView boundaryView_;
  gpu::TexelView windingView_;
};

}  // namespace tetralux::render
