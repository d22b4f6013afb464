// How rays get from cell to cell, on the device: what the march needs beside the mesh.
#pragma once

#include <cstdint>

#include "gpu/buffer.h"
#include "mesh/adjacency.h"

namespace tetralux::render {

// 32 bytes per cell and 16 per boundary face.
class WalkTopology {
 public:
  //   adjacency   without folds (mesh/cut_folds.h); neither it nor the mesh need outlive the call
  WalkTopology(const gpu::Context& context, const TetMesh& mesh, const Adjacency& adjacency);

  // Two uint per face of a cell, faces numbered as in Adjacency: the cell across it, or kNoCell, and that cell's vertex
  // opposite.
  const gpu::TexelView& across() const { return acrossView_; }
  VkDeviceAddress acrossAddress() const { return acrossBuffer_.address(); }

  // Boundary faces: three vertices, (b - a) x (c - a) points outwards, and which face of which cell it is
  // (include/ray_walk.glsl).
  const gpu::TexelView& boundary() const { return boundaryView_; }
  VkDeviceAddress boundaryAddress() const { return boundaryBuffer_.address(); }
  std::uint32_t boundaryCount() const { return boundaryCount_; }

  std::uint64_t sizeBytes() const;

 private:
  std::uint32_t boundaryCount_;
  gpu::Buffer acrossBuffer_;
  gpu::Buffer boundaryBuffer_;
  gpu::TexelView acrossView_;
  gpu::TexelView boundaryView_;
};

}  // namespace tetralux::render
