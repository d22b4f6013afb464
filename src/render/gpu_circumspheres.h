// The spheres through the cells' vertices, on the device: what the power order needs beside the mesh.
#pragma once

#include "gpu/buffer.h"
#include "mesh/adjacency.h"
#include "mesh/tet_mesh.h"
#include "render/mesh_space.h"

namespace tetralux::render {

// Addresses of the spheres' buffers, as the shaders' SphereAddresses.
struct SphereAddresses {
  VkDeviceAddress leading;
  VkDeviceAddress rest;
};

// A sphere with centre c and radius r in mesh space is four numbers: c and |c|^2 - r^2, the power of the origin. The
// power of any point e is then linear in them, |e|^2 - 2 e . c + (|c|^2 - r^2). Each is kept in 40 bits, a float and 16
// bits of what the float leaves: cells on either side of a face differ by little where they are nearly cospherical, and
// a float alone puts some faces of a million in the wrong order. 24 bytes per cell.
class GpuCircumspheres {
 public:
  // Cospherical neighbours (mesh/cospherical.h) get the same sphere to the last bit.
  // Throws Error(Device) when it does not fit the device. 52 bytes per cell while it runs; nothing is kept.
  //   space   the device mesh's
  GpuCircumspheres(const gpu::Context& context, const TetMesh& mesh, const Adjacency& adjacency,
                   const MeshSpace& space);

  const gpu::TexelView& leading() const { return leadingView_; }
  const gpu::TexelView& rest() const { return restView_; }
  SphereAddresses addresses() const { return {leading_.address(), rest_.address()}; }
  std::uint64_t sizeBytes() const { return leading_.sizeBytes() + rest_.sizeBytes(); }

 private:
  gpu::Buffer leading_;
  gpu::Buffer rest_;
  gpu::TexelView leadingView_;
  gpu::TexelView restView_;
};

}  // namespace tetralux::render
