// The mesh on the device.
#pragma once

#include <cstdint>

#include "gpu/pieced_buffer.h"
#include "mesh/tet_mesh.h"
#include "render/mesh_space.h"

namespace tetralux::render {

// Addresses of the mesh's buffers, as the shaders' MeshAddresses; cells: of a table of pieces.
struct MeshAddresses {
  VkDeviceAddress cells;
  VkDeviceAddress vertices;
  VkDeviceAddress cellScalars;
};

// Vertices (position in mesh space, scalar), cells (four indices, ascending) and, for a cell field, one scalar per
// cell. 16 bytes per vertex, 16 (or 20) per cell.
class GpuMesh {
 public:
  // Throws Error(Device) when it does not fit the device. The mesh itself is not kept.
  //   pieceBits   of the list of cells (gpu/pieced_buffer.h); fewer for tests
  GpuMesh(const gpu::Context& context, const TetMesh& mesh, const ScalarField& field,
          unsigned pieceBits = gpu::kPieceBits);

  const MeshSpace& space() const { return space_; }
  std::uint32_t cellCount() const { return cellCount_; }
  std::uint32_t vertexCount() const { return vertexCount_; }
  bool isCellField() const { return isCellField_; }
  std::uint64_t sizeBytes() const;

  const gpu::TexelView& cells() const { return cellView_; }
  const gpu::TexelView& vertices() const { return vertexView_; }
  const gpu::TexelView& cellScalars() const { return cellScalarView_; }
  MeshAddresses addresses() const;

 private:
  MeshSpace space_;
  std::uint32_t cellCount_;
  std::uint32_t vertexCount_;
  bool isCellField_;
  gpu::Buffer vertexBuffer_;
  gpu::PiecedBuffer cellBuffer_;
  gpu::Buffer cellScalarBuffer_;
  gpu::TexelView vertexView_;
  gpu::TexelView cellView_;
  gpu::TexelView cellScalarView_;
};

}  // namespace tetralux::render
