// Device memory of the march beside the mesh.
#pragma once

#include <memory>

#include "render/gpu_topology.h"
#include "render/pixel_lists.h"
#include "shared/frame_view.h"

namespace tetralux::render {

class MarchStorage {
 public:
  //   adjacency   without folds (mesh/cut_folds.h); need not outlive the call
  MarchStorage(const gpu::Context& context, const Adjacency& adjacency);

  // Room for a picture; nothing when there is enough already. Throws Error(Device).
  void prepare(ImageSize size);

  const GpuTopology& topology() const { return topology_; }
  const gpu::Buffer& view() const { return view_; }  // FrameView
  PixelLists& lists() const { return *lists_; }      // faces where rays enter; links and codes (include/ray_walk.glsl)
  const gpu::Buffer& colors() const { return colors_; }  // vec4 per pixel of a band
  const gpu::TexelView& colorsView() const { return colorsView_; }
  const gpu::Buffer& unfinished() const { return unfinished_; }  // one uint: rays that are not through

  std::uint64_t sizeBytes() const;

 private:
  const gpu::Context& context_;
  GpuTopology topology_;
  gpu::Buffer view_;
  gpu::Buffer unfinished_;
  std::unique_ptr<PixelLists> lists_;  // made with the first picture
  gpu::Buffer colors_;
  gpu::TexelView colorsView_;
};

}  // namespace tetralux::render
