// Device memory with numbers in it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gpu/context.h"
#include "gpu/vulkan.h"

namespace tetralux::gpu {

// Which side of the bus a buffer is on.
enum class MemoryKind {
  Device,    // fast for the device; mapped only where all memory is one
  Readback,  // mapped, cached: the device writes, the host reads
  Upload,    // mapped: the host writes, the device reads
};

// A buffer with memory of its own, usable in every way that the frame uses one. Move-only.
class Buffer {
 public:
  Buffer() = default;
  // Throws Error(Device) when there is no memory for it or the device limits single allocations to less.
  //   sizeBytes   rounded up to a multiple of 4, at least 4
  //   name        shown in messages
  Buffer(const Context& context, std::uint64_t sizeBytes, MemoryKind kind, const std::string& name);

  VkBuffer get() const { return buffer_.get(); }
  std::uint64_t sizeBytes() const { return sizeBytes_; }
  VkDeviceAddress address() const { return address_; }
  // Mapped memory, or null.
  void* mapped() const { return mapped_; }

  template <typename T>
  std::span<T> as() const {
    return {static_cast<T*>(mapped_), sizeBytes_ / sizeof(T)};
  }

 private:
  std::uint64_t sizeBytes_ = 0;
  void* mapped_ = nullptr;
  VkDeviceAddress address_ = 0;
  DeviceHandle<VkDeviceMemory> memory_;
  DeviceHandle<VkBuffer> buffer_;  // declared after its memory: destroyed before it
};

// A typed window on a buffer, read with texelFetch.
class TexelView {
 public:
  TexelView() = default;
  //   elements   0: all that fit; more than the device allows: as many as it allows
  TexelView(const Context& context, const Buffer& buffer, VkFormat format, std::uint64_t elements = 0);

  VkBufferView get() const { return view_.get(); }

 private:
  DeviceHandle<VkBufferView> view_;
};

// Copies host memory into a buffer and waits. Through a staging buffer of at most 64 MiB where the buffer is not
// mapped. May not overlap with work of the device on that buffer.
void upload(const Context& context, const Buffer& buffer, const void* data, std::uint64_t sizeBytes,
            std::uint64_t offsetBytes = 0);

// The same back to the host.
void download(const Context& context, const Buffer& buffer, void* data, std::uint64_t sizeBytes,
              std::uint64_t offsetBytes = 0);

template <typename T>
std::vector<T> downloadVector(const Context& context, const Buffer& buffer, size_t count) {
  std::vector<T> result(count);
  download(context, buffer, result.data(), count * sizeof(T));
  return result;
}

// A device buffer that holds these numbers.
template <typename T>
Buffer makeBuffer(const Context& context, const std::vector<T>& values, const std::string& name) {
  Buffer buffer(context, values.size() * sizeof(T), MemoryKind::Device, name);
  upload(context, buffer, values.data(), values.size() * sizeof(T));
  return buffer;
}

}  // namespace tetralux::gpu
