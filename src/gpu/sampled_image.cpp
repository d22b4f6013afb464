#include "gpu/sampled_image.h"

#include <algorithm>

#include "base/error.h"

namespace tetralux::gpu {

bool filtersLinearly(const Context& context, VkFormat format) {
  VkFormatProperties properties;
  vkGetPhysicalDeviceFormatProperties(context.physicalDevice(), format, &properties);
  return (properties.optimalTilingFeatures & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0;
}

SampledImage::SampledImage(const Context& context, const ImageExtent& extent, VkFormat format, const std::string& name)
    : extent_(extent) {
  const bool is3d = extent.depth > 0;
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = is3d ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {extent.width, extent.height, is3d ? extent.depth : 1};
  info.mipLevels = 1;
  info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  VkImageFormatProperties limits;
  const VkResult supported = vkGetPhysicalDeviceImageFormatProperties(context.physicalDevice(), format, info.imageType,
                                                                      info.tiling, info.usage, 0, &limits);
  if (supported == VK_ERROR_FORMAT_NOT_SUPPORTED)
    fail(ErrorCode::Device, "{}: device '{}' has no such format", name, context.info().name);
  VK_CHECK(supported);
  if (extent.width > limits.maxExtent.width || extent.height > limits.maxExtent.height ||
      extent.depth > limits.maxExtent.depth)
    fail(ErrorCode::Device, "{} of {}x{}x{} texels, device '{}' allows {}x{}x{}", name, extent.width, extent.height,
         extent.depth, context.info().name, limits.maxExtent.width, limits.maxExtent.height, limits.maxExtent.depth);
  // The device's own limit for one image, before a driver meets a size that overflows its arithmetic.
  const std::uint64_t leastBytes = extent.texels();
  if (leastBytes > limits.maxResourceSize)
    fail(ErrorCode::Device, "{} of {}x{}x{} texels, device '{}' allows {} MiB", name, extent.width, extent.height,
         extent.depth, context.info().name, limits.maxResourceSize >> 20);
  VkImage image = VK_NULL_HANDLE;
  VK_CHECK(vkCreateImage(context.device(), &info, nullptr, &image));
  image_ = {context.device(), image, vkDestroyImage};
  context.setName(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<std::uint64_t>(image), name);

  VkMemoryRequirements needed;
  vkGetImageMemoryRequirements(context.device(), image, &needed);
  sizeBytes_ = needed.size;
  if (context.info().largestAllocationBytes != 0 && needed.size > context.info().largestAllocationBytes)
    fail(ErrorCode::Device, "out of memory: {} needs {} MiB, device '{}' allows {} MiB in one piece", name,
         needed.size >> 20, context.info().name, context.info().largestAllocationBytes >> 20);
  VkMemoryAllocateInfo memoryInfo{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  memoryInfo.allocationSize = needed.size;
  memoryInfo.memoryTypeIndex = context.memoryType(needed.memoryTypeBits, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0);
  VkDeviceMemory memory = VK_NULL_HANDLE;
  const VkResult allocated = vkAllocateMemory(context.device(), &memoryInfo, nullptr, &memory);
  if (allocated == VK_ERROR_OUT_OF_DEVICE_MEMORY || allocated == VK_ERROR_OUT_OF_HOST_MEMORY)
    fail(ErrorCode::Device, "out of memory: {} needs {} MiB on device '{}'", name, needed.size >> 20,
         context.info().name);
  VK_CHECK(allocated);
  memory_ = {context.device(), memory, vkFreeMemory};
  VK_CHECK(vkBindImageMemory(context.device(), image, memory, 0));

  VkImageViewCreateInfo viewInfo{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  viewInfo.image = image;
  viewInfo.viewType = is3d ? VK_IMAGE_VIEW_TYPE_3D : VK_IMAGE_VIEW_TYPE_2D;
  viewInfo.format = format;
  viewInfo.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  VkImageView view = VK_NULL_HANDLE;
  VK_CHECK(vkCreateImageView(context.device(), &viewInfo, nullptr, &view));
  view_ = {context.device(), view, vkDestroyImageView};

  const VkFilter filter = filtersLinearly(context, format) ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
  VkSamplerCreateInfo samplerInfo{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  samplerInfo.magFilter = filter;
  samplerInfo.minFilter = filter;
  samplerInfo.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
  samplerInfo.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  samplerInfo.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  samplerInfo.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  VkSampler sampler = VK_NULL_HANDLE;
  VK_CHECK(vkCreateSampler(context.device(), &samplerInfo, nullptr, &sampler));
  sampler_ = {context.device(), sampler, vkDestroySampler};
}

}  // namespace tetralux::gpu
