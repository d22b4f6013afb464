#include "gpu/image.h"

#include <algorithm>

#include "base/error.h"

namespace tetralux::gpu {

AttachmentImage::AttachmentImage(const Context& context, std::uint32_t width, std::uint32_t height, VkFormat format,
                                 const std::string& name, bool isSampled)
    : width_(width), height_(height), format_(format) {
  const std::uint32_t limit = context.info().largestImageSide;
  if (width > limit || height > limit)
    fail(ErrorCode::Device, "image of {}x{} pixels, device '{}' allows {} a side", width, height, context.info().name,
         limit);
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {width, height, 1};
  info.mipLevels = 1;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  if (isSampled) info.usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
  VkImage image = VK_NULL_HANDLE;
  VK_CHECK(vkCreateImage(context.device(), &info, nullptr, &image));
  image_ = {context.device(), image, vkDestroyImage};
  context.setName(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(image), name);

  VkMemoryRequirements needed;
  vkGetImageMemoryRequirements(context.device(), image, &needed);
  sizeBytes_ = needed.size;
  VkMemoryAllocateInfo memoryInfo{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  memoryInfo.allocationSize = needed.size;
  memoryInfo.memoryTypeIndex = context.memoryType(needed.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0);
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VK_CHECK(vkAllocateMemory(context.device(), &memoryInfo, nullptr, &memory));
  memory_ = {context.device(), memory, vkFreeMemory};
  VK_CHECK(vkBindImageMemory(context.device(), image, memory, 0));

  VkImageViewCreateInfo viewInfo{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  viewInfo.image = image;
  viewInfo.viewType = VK_IMAGE_VIEW_TYPE_2D;
  viewInfo.format = format;
  viewInfo.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  VkImageView view = VK_NULL_HANDLE;
  VK_CHECK(vkCreateImageView(context.device(), &viewInfo, nullptr, &view));
  view_ = {context.device(), view, vkDestroyImageView};
}

}  // namespace tetralux::gpu
