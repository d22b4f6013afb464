// How cells are connected, on the device: what every exact order needs beside the mesh. Made only when one is asked
// for.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gpu/buffer.h"
#include "mesh/adjacency.h"

namespace tetralux::render {

// Addresses of the topology's buffers, as the shaders' TopologyAddresses.
struct TopologyAddresses {
  VkDeviceAddress neighbors;
  VkDeviceAddress sides;
};

// 17 bytes per cell, 16 per boundary face and 8 per pair of overlapping cells.
class GpuTopology {
 public:
  GpuTopology(const gpu::Context& context, const Adjacency& adjacency,
              const std::vector<std::array<std::uint32_t, 2>>& overlaps);

  const gpu::Buffer& neighborBuffer() const { return neighborBuffer_; }
  const gpu::TexelView& neighbors() const { return neighborView_; }
  const gpu::TexelView& sides() const { return sideView_; }
  TopologyAddresses addresses() const { return {neighborBuffer_.address(), sideBuffer_.address()}; }

  // Boundary faces: three vertex indices each, and the cell.
  const gpu::TexelView& boundaryVertices() const { return boundaryVertexView_; }
  const gpu::TexelView& boundaryCells() const { return boundaryCellView_; }
  VkDeviceAddress boundaryVertexAddress() const { return boundaryVertexBuffer_.address(); }
  VkDeviceAddress boundaryCellAddress() const { return boundaryCellBuffer_.address(); }
  std::uint32_t boundaryCount() const { return boundaryCount_; }

  // Pairs of cells that overlap (mesh/overlaps.h).
  const gpu::TexelView& overlaps() const { return overlapView_; }
  std::uint32_t overlapCount() const { return overlapCount_; }

  // No ray leaves the mesh and comes back.
  bool isConvex() const { return isConvex_; }
  std::uint64_t sizeBytes() const;

 private:
  bool isConvex_;
  std::uint32_t boundaryCount_;
  std::uint32_t overlapCount_;
  gpu::Buffer neighborBuffer_;
  gpu::Buffer sideBuffer_;
  gpu::Buffer boundaryVertexBuffer_;
  gpu::Buffer boundaryCellBuffer_;
  gpu::Buffer overlapBuffer_;
  gpu::TexelView neighborView_;
  gpu::TexelView sideView_;
  gpu::TexelView boundaryVertexView_;
  gpu::TexelView boundaryCellView_;
  gpu::TexelView overlapView_;
};

}  // namespace tetralux::render
