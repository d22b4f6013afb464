// Device memory for lists of fragments, one list for every pixel of a band of rows.
#pragma once

#include <cstdint>

#include "gpu/commands.h"
#include "shared/pixel_lists.h"
#include "view/camera.h"

namespace tetralux::render {

// Starts with room for what most pictures need and grows when a pass ran out of it: up to a limit by larger buffers, beyond
// by narrower bands.
class PixelLists {
 public:
  //   withColors   nodes also hold a colour (28 bytes a node), otherwise only their rank (12 bytes)
  PixelLists(const gpu::Context& context, ImageSize size, bool withColors);

  ImageSize size() const { return size_; }
  std::uint32_t bandCount() const { return (size_.height + bandRows_ - 1) / bandRows_; }
  shared::PixelBand band(std::uint32_t index) const;
  // The band that begins with a row, as index 0: for work that is finished band by band.
  shared::PixelBand bandFrom(std::uint32_t firstRow) const;
  std::uint64_t bandPixels() const { return std::uint64_t{size_.width} * bandRows_; }

  const gpu::Buffer& heads() const { return heads_; }    // uint per pixel of the band
  const gpu::Buffer& links() const { return links_; }    // uint per node
  const gpu::Buffer& ranks() const { return ranks_; }    // uvec2 per node
  const gpu::Buffer& colors() const { return colors_; }  // vec4 per node
  const gpu::Buffer& counts() const { return counts_; }  // uint per band: nodes wanted

  // Records the emptying of all counts, and of all lists before a band. Transfer writes: barriers are owed.
  void recordClearCounts(gpu::CommandBuffer& commands) const { commands.fill(counts_, 0); }
  void recordClearLists(gpu::CommandBuffer& commands) const { commands.fill(heads_, shared::NO_NODE); }

  // After the work is done: whether any band wanted more nodes than there are. If so there is room for more now, and
  // all bands (which may be others) have to be done again. Throws Error(Device) when there is no memory.
  bool grow();

  std::uint64_t sizeBytes() const;

 private:
  void allocate();

  const gpu::Context* context_;
  ImageSize size_;
  bool withColors_;
  std::uint32_t bandRows_;
  std::uint32_t capacity_;
  gpu::Buffer heads_;
  gpu::Buffer links_;
  gpu::Buffer ranks_;
  gpu::Buffer colors_;
  gpu::Buffer counts_;
};

}  // namespace tetralux::render
