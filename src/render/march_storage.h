// Device memory of the march beside the mesh.
#pragma once

#include <cstdint>

#include "gpu/commands.h"
#include "render/mesh_space.h"
#include "render/walk_topology.h"
#include "shared/frame_view.h"
#include "shared/march.h"
#include "shared/pixel_lists.h"
#include "view/camera.h"

namespace tetralux::render {

// How much of a band's work a storage can list.
struct MarchRoom {
  std::uint32_t jobs = 0;
  std::uint32_t nodes = 0;

  bool holds(const shared::MarchCounts& counts) const { return counts.jobs <= jobs && counts.nodes <= nodes; }
};

// Pictures are drawn in bands of rows. Jobs and lists start with room for what most pictures need and grow when a band
// ran out of it: up to a limit by larger buffers, beyond by narrower bands.
class MarchStorage {
 public:
  //   adjacency   without folds (mesh/cut_folds.h); neither it nor the mesh need outlive the call
  //   pieceBits   of the topology's list of cells; fewer for tests
  MarchStorage(const gpu::Context& context, const TetMesh& mesh, const MeshSpace& space, const Adjacency& adjacency,
               unsigned pieceBits = gpu::kPieceBits);

  // Room for a picture; nothing when there is enough already. Throws Error(Device).
  //   boundaryCount   faces through which rays may enter; for a new size, where more turn out to be needed grow() sees
  //                   to it
  void prepare(ImageSize size, std::uint32_t boundaryCount);

  // The band that begins with a row.
  shared::PixelBand bandFrom(std::uint32_t firstRow) const;

  // Records that a band has no jobs, lists, tiles and colours yet. Transfer writes: barriers are owed.
  void recordClear(gpu::CommandBuffer& commands) const;
  // The same for the number of rays that are not through, with the barrier.
  void recordClearUnfinished(gpu::CommandBuffer& commands) const;
  // Copies counts() to the host.
  void recordReadCounts(gpu::CommandBuffer& commands, const gpu::Buffer& hostCounts) const;

  // After the work is done: whether the band had more to store than there was room for. If so there is room for more
  // now, and the band (which may be another) has to be done again. Throws Error(Device) when there is no memory.
  bool grow(const shared::MarchCounts& counts);
  const MarchRoom& room() const { return room_; }

  const WalkTopology& topology() const { return topology_; }
  // What single precision leaves of the vertices' positions, vec4 each; one of zeros where the device has no double
  // precision.
  const gpu::TexelView& vertexRests() const { return restView_; }
  VkDeviceAddress vertexRestAddress() const { return restBuffer_.address(); }
  const gpu::Buffer& view() const { return view_; }              // FrameView
  const gpu::Buffer& counts() const { return counts_; }          // MarchCounts
  const gpu::Buffer& hostCounts() const { return hostCounts_; }  // the same where the host can read them
  const gpu::Buffer& jobs() const { return jobs_; }              // uvec4
  const gpu::TexelView& jobsView() const { return jobsView_; }
  const gpu::Buffer& tileMarks() const { return tileMarks_; }  // uint per tile
  const gpu::Buffer& walkTiles() const { return walkTiles_; }  // uint: tiles with jobs
  const gpu::Buffer& sortTiles() const { return sortTiles_; }  // uint: tiles with longer lists
  const gpu::Buffer& heads() const { return heads_; }          // include/pixel_lists.glsl
  const gpu::Buffer& links() const { return links_; }
  const gpu::Buffer& ranks() const { return ranks_; }
  const gpu::Buffer& colors() const { return colors_; }  // vec4 per pixel of a band
  const gpu::TexelView& colorsView() const { return colorsView_; }

  // Rows of a picture of that size that are drawn at a time.
  std::uint32_t bandRows() const { return bandRows_; }
  // Pixels, and tiles of MARCH_TILE squared, of the largest band.
  std::uint64_t bandPixels() const;
  std::uint64_t bandTiles() const;

  std::uint64_t sizeBytes() const;

 private:
  void allocate();

  const gpu::Context& context_;
  WalkTopology topology_;
  gpu::Buffer restBuffer_;
  gpu::TexelView restView_;
  gpu::Buffer view_;
  gpu::Buffer counts_;
  gpu::Buffer hostCounts_;
  ImageSize size_{0, 0};  // of the picture that there is room for
  std::uint32_t bandRows_ = 0;
  MarchRoom room_;
  gpu::Buffer jobs_;
  gpu::Buffer tileMarks_;
  gpu::Buffer walkTiles_;
  gpu::Buffer sortTiles_;
  gpu::Buffer heads_;
  gpu::Buffer links_;
  gpu::Buffer ranks_;
  gpu::Buffer colors_;
  gpu::TexelView jobsView_;
  gpu::TexelView colorsView_;
};

}  // namespace tetralux::render
