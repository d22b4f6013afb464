// Pass "surfaces": opaque triangles that end rays (docs/appearance.md).
#pragma once

#include <optional>
#include <vector>

#include "gpu/commands.h"
#include "render/appearance_buffer.h"
#include "render/frame_view.h"
#include "render/gpu_mesh.h"
#include "render/pipeline_variants.h"
#include "shared/march.h"
#include "shared/pixel_lists.h"

namespace tetralux::render {

// All triangles of a scene on the device, and what a band of pixels needs to find the nearest.
class SurfaceStorage {
 public:
  // Throws Error(Device) when they do not fit the device.
  SurfaceStorage(const gpu::Context& context, const std::vector<OpaqueSurface>& surfaces, const MeshSpace& space);

  // Room for a band of so many pixels in so many tiles.
  void prepare(std::uint64_t pixels, std::uint64_t tiles);
  // Whether a band had more jobs than there was room for; if so, there is room now, and it has to be done again.
  bool grow();

  std::uint32_t triangleCount() const { return triangleCount_; }
  std::uint64_t sizeBytes() const;

 private:
  friend class SurfacePass;

  const gpu::Context& context_;
  std::uint32_t triangleCount_ = 0;
  std::uint32_t jobCapacity_ = 0;
  gpu::Buffer vertices_;
  gpu::Buffer normals_;
  gpu::Buffer triangles_;
  gpu::Buffer materials_;
  gpu::Buffer counts_;  // MarchCounts
  gpu::Buffer jobs_;
  gpu::Buffer tileMarks_;
  gpu::Buffer tiles_;
  gpu::Buffer nearest_;
  gpu::Buffer chosen_;
  gpu::Buffer rayEnds_;
  gpu::TexelView vertexView_;
  gpu::TexelView normalView_;
  gpu::TexelView triangleView_;
  gpu::TexelView materialView_;
  gpu::TexelView jobsView_;
  gpu::TexelView rayEndsView_;

 public:
  // Per pixel of a band: rgb and depth of the surface that ends the ray.
  const gpu::TexelView& rayEnds() const { return rayEndsView_; }
};

class SurfacePass {
 public:
  explicit SurfacePass(const gpu::Context& context);

  // Finds where the rays of a band end. When there was too little room (SurfaceStorage::grow), what follows is wrong.
  //   view   FrameView
  void record(gpu::CommandBuffer& commands, const FrameVariant& variant, const AppearanceBuffer& appearance,
              const gpu::Buffer& view, const SurfaceStorage& storage, const shared::PixelBand& band);

  // Composites the surfaces behind the band's colours, vec4 per pixel.
  void recordBehind(gpu::CommandBuffer& commands, const SurfaceStorage& storage, const gpu::Buffer& colors,
                    const shared::PixelBand& band);

 private:
  ComputeVariants bin_;
  ComputeVariants meet_;
  ComputeVariants shade_;
  ComputeVariants behind_;
};

}  // namespace tetralux::render
