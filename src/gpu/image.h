// Pictures on the device: colour attachments that can be copied to the host.
#pragma once

#include <cstdint>
#include <string>

#include "gpu/context.h"

namespace tetralux::gpu {

class AttachmentImage {
 public:
  AttachmentImage() = default;
  //   isSampled   shaders will read it, too
  // Throws Error(Device) when the sides are beyond the device's limit or memory is short.
  AttachmentImage(const Context& context, std::uint32_t width, std::uint32_t height, VkFormat format,
                  const std::string& name, bool isSampled = false);

  VkImage get() const { return image_.get(); }
  VkImageView view() const { return view_.get(); }
  VkFormat format() const { return format_; }
  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  std::uint64_t sizeBytes() const { return sizeBytes_; }

 private:
  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;
  VkFormat format_ = VK_FORMAT_UNDEFINED;
  std::uint64_t sizeBytes_ = 0;
  DeviceHandle<VkDeviceMemory> memory_;
  DeviceHandle<VkImage> image_;
  DeviceHandle<VkImageView> view_;
};

}  // namespace tetralux::gpu
