#include "gpu/buffer.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "base/check.h"
#include "base/error.h"
#include "gpu/commands.h"

namespace tetralux::gpu {
namespace {

constexpr std::uint64_t kStagingBytes = 64ull << 20;

VkDeviceMemory allocate(const Context& context, const VkMemoryRequirements& needed, MemoryKind kind,
                        const std::string& name, bool& isMappable) {
  VkMemoryPropertyFlags required = 0;
  VkMemoryPropertyFlags preferred = 0;
  constexpr VkMemoryPropertyFlags kMapped = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  switch (kind) {
    case MemoryKind::Device:
      required = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
      break;
    case MemoryKind::Readback:
      required = kMapped;
      preferred = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
      break;
    case MemoryKind::Upload:
      required = kMapped;
      break;
  }
  if (context.info().largestAllocationBytes != 0 && needed.size > context.info().largestAllocationBytes)
    fail(ErrorCode::Device, "out of memory: {} needs {} MiB, device '{}' allows {} MiB in one piece", name,
         needed.size >> 20, context.info().name, context.info().largestAllocationBytes >> 20);
  const std::uint32_t type = context.memoryType(needed.memoryTypeBits, required, preferred);
  VkPhysicalDeviceMemoryProperties properties;
  vkGetPhysicalDeviceMemoryProperties(context.physicalDevice(), &properties);
  isMappable = (properties.memoryTypes[type].propertyFlags & kMapped) == kMapped;

  VkMemoryAllocateFlagsInfo flags{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO};
  flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, &flags};
  info.allocationSize = needed.size;
  info.memoryTypeIndex = type;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  const VkResult result = vkAllocateMemory(context.device(), &info, nullptr, &memory);
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY)
    fail(ErrorCode::Device, "out of memory: {} needs {} MiB on device '{}'", name, needed.size >> 20,
         context.info().name);
  VK_CHECK(result);
  return memory;
}

}  // namespace

std::uint64_t bytesPerTexel(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R8_UINT:
      return 1;
    case VK_FORMAT_R32G32_SFLOAT:
    case VK_FORMAT_R32G32_UINT:
      return 8;
    case VK_FORMAT_R32_UINT:
    case VK_FORMAT_R32_SFLOAT:
      return 4;
    case VK_FORMAT_R32G32B32A32_UINT:
    case VK_FORMAT_R32G32B32A32_SFLOAT:
      return 16;
    default:
      checkFailed(__FILE__, __LINE__, "a texel format that nothing here uses");
  }
}

Buffer::Buffer(const Context& context, std::uint64_t sizeBytes, MemoryKind kind, const std::string& name)
    : sizeBytes_((std::max<std::uint64_t>(sizeBytes, 4) + 3) / 4 * 4) {
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = allocatedBytes();
  info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  if (kind == MemoryKind::Device) {
    info.usage |= VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
                  VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_VERTEX_BUFFER_BIT |
                  VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
                  VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
  }
  VkBuffer buffer = VK_NULL_HANDLE;
  VK_CHECK(vkCreateBuffer(context.device(), &info, nullptr, &buffer));
  buffer_ = {context.device(), buffer, vkDestroyBuffer};
  context.setName(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<std::uint64_t>(buffer), name);

  VkMemoryRequirements needed;
  vkGetBufferMemoryRequirements(context.device(), buffer, &needed);
  bool isMappable = false;
  memory_ = {context.device(), allocate(context, needed, kind, name, isMappable), vkFreeMemory};
  VK_CHECK(vkBindBufferMemory(context.device(), buffer, memory_.get(), 0));
  if (isMappable) VK_CHECK(vkMapMemory(context.device(), memory_.get(), 0, VK_WHOLE_SIZE, 0, &mapped_));
  if (kind == MemoryKind::Device) {
    VkBufferDeviceAddressInfo addressInfo{VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO};
    addressInfo.buffer = buffer;
    address_ = vkGetBufferDeviceAddress(context.device(), &addressInfo);
  }
}

TexelView::TexelView(const Context& context, const Buffer& buffer, VkFormat format, std::uint64_t offsetBytes,
                     std::uint64_t sizeBytes) {
  const std::uint64_t texelBytes = bytesPerTexel(format);
  CHECK_EQ(offsetBytes % kTexelViewAlignment, 0u);
  CHECK_LE(offsetBytes + sizeBytes, buffer.allocatedBytes());
  const std::uint64_t elements = (sizeBytes > 0 ? sizeBytes : buffer.allocatedBytes() - offsetBytes) / texelBytes;
  VkBufferViewCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO};
  info.buffer = buffer.get();
  info.format = format;
  info.offset = offsetBytes;
  info.range = std::min<std::uint64_t>(elements, context.info().largestTexelBuffer) * texelBytes;
  VkBufferView view = VK_NULL_HANDLE;
  VK_CHECK(vkCreateBufferView(context.device(), &info, nullptr, &view));
  view_ = {context.device(), view, vkDestroyBufferView};
}

void upload(const Context& context, const Buffer& buffer, const void* data, std::uint64_t sizeBytes,
            std::uint64_t offsetBytes) {
  CHECK_LE(offsetBytes + sizeBytes, buffer.sizeBytes());
  if (sizeBytes == 0) return;
  if (buffer.mapped()) {
    std::memcpy(static_cast<char*>(buffer.mapped()) + offsetBytes, data, sizeBytes);
    return;
  }
  if (sizeBytes <= kSmallBytes && sizeBytes % 4 == 0) {
    CommandBuffer commands(context);
    commands.update(buffer, data, sizeBytes, offsetBytes);
    commands.barrier(access::kTransferWrite, access::kAnyRead);
    commands.submitAndWait();
    return;
  }
  const Buffer staging(context, std::min(sizeBytes, kStagingBytes), MemoryKind::Upload, "staging");
  for (std::uint64_t done = 0; done < sizeBytes; done += kStagingBytes) {
    const std::uint64_t part = std::min(kStagingBytes, sizeBytes - done);
    std::memcpy(staging.mapped(), static_cast<const char*>(data) + done, part);
    CommandBuffer commands(context);
    commands.copy(staging, 0, buffer, offsetBytes + done, part);
    commands.barrier(access::kTransferWrite, access::kAnyRead);
    commands.submitAndWait();
  }
}

void uploadPieces(const Context& context, const Buffer& buffer,
                  const std::function<void(std::span<std::byte>, std::uint64_t)>& fill) {
  std::optional<Buffer> staging;
  if (!buffer.mapped())
    staging.emplace(context, std::min(buffer.sizeBytes(), kStagingBytes), MemoryKind::Upload, "staging");
  for (std::uint64_t done = 0; done < buffer.sizeBytes(); done += kStagingBytes) {
    const std::uint64_t part = std::min(kStagingBytes, buffer.sizeBytes() - done);
    auto* bytes = static_cast<std::byte*>(staging ? staging->mapped() : buffer.mapped());
    fill({staging ? bytes : bytes + done, part}, done);
    if (!staging) continue;
    CommandBuffer commands(context);
    commands.copy(*staging, 0, buffer, done, part);
    commands.barrier(access::kTransferWrite, access::kAnyRead);
    commands.submitAndWait();
  }
}

void download(const Context& context, const Buffer& buffer, void* data, std::uint64_t sizeBytes,
              std::uint64_t offsetBytes) {
  CHECK_LE(offsetBytes + sizeBytes, buffer.sizeBytes());
  if (sizeBytes == 0) return;
  if (buffer.mapped()) {
    std::memcpy(data, static_cast<const char*>(buffer.mapped()) + offsetBytes, sizeBytes);
    return;
  }
  std::optional<Buffer> large;
  if (sizeBytes > kSmallBytes)
    large.emplace(context, std::min(sizeBytes, kStagingBytes), MemoryKind::Readback, "staging");
  const Buffer& staging = large ? *large : context.smallReadback();
  for (std::uint64_t done = 0; done < sizeBytes; done += kStagingBytes) {
    const std::uint64_t part = std::min(kStagingBytes, sizeBytes - done);
    CommandBuffer commands(context);
    commands.barrier(access::kAnyWrite, access::kTransferRead);
    commands.copy(buffer, offsetBytes + done, staging, 0, part);
    commands.barrier(access::kTransferWrite, access::kHostRead);
    commands.submitAndWait();
    std::memcpy(static_cast<char*>(data) + done, staging.mapped(), part);
  }
}

}  // namespace tetralux::gpu
