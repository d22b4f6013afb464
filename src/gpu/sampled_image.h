// Tables on the device that shaders look into with interpolation.
#pragma once

#include <cstdint>
#include <string>

#include "gpu/context.h"

namespace tetralux::gpu {

// Texels along each axis; a depth of 0 is an image of two dimensions.
struct ImageExtent {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint32_t depth = 0;

  std::uint64_t texels() const { return std::uint64_t{width} * height * (depth == 0 ? 1 : depth); }
  bool operator==(const ImageExtent&) const = default;
};

// Whether a device interpolates between texels of a format. Optional for 32-bit floats and, on some devices, for 16-bit
// integers; an image of a format without it can still be read texel by texel.
bool filtersLinearly(const Context& context, VkFormat format);

// An image with its sampler: linear where the device can, edges clamped. Filled by CommandBuffer::copyToImage.
// Move-only.
class SampledImage {
 public:
  SampledImage() = default;
  // Throws Error(Device) when a side is beyond the device's limit or memory is short.
  SampledImage(const Context& context, const ImageExtent& extent, VkFormat format, const std::string& name);

  VkImage get() const { return image_.get(); }
  VkImageView view() const { return view_.get(); }
  VkSampler sampler() const { return sampler_.get(); }
  const ImageExtent& extent() const { return extent_; }
  std::uint64_t sizeBytes() const { return sizeBytes_; }

 private:
  ImageExtent extent_;
  std::uint64_t sizeBytes_ = 0;
  DeviceHandle<VkDeviceMemory> memory_;
  DeviceHandle<VkImage> image_;
  DeviceHandle<VkImageView> view_;
  DeviceHandle<VkSampler> sampler_;
};

}  // namespace tetralux::gpu
