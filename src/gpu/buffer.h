// Device memory with numbers in it.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "gpu/context.h"
#include "gpu/vulkan.h"

namespace tetralux::gpu {

// What counts as little where host and device exchange it: drivers take up to a millisecond to give memory and take it
// back, many times what a copy takes, so for this much there is a way without.
inline constexpr std::uint64_t kSmallBytes = 1u << 16;

// Which side of the bus a buffer is on.
enum class MemoryKind {
  Device,    // fast for the device; mapped only where all memory is one
  Readback,  // mapped, cached: the device writes, the host reads
  Upload,    // mapped: the host writes, the device reads
};

// Lavapipe compiles a shader anew for texel buffers whose size in bytes is a power of two, and for such without a bit
// from the 8th to the 15th. With this size, not much larger, a shader is compiled once, whatever the mesh.
constexpr std::uint64_t paddedTexelBytes(std::uint64_t bytes) {
  while ((bytes >> 8 & 0xffu) == 0 || std::has_single_bit(bytes)) bytes += 256;
  return bytes;
}

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
  // A little more than that: paddedTexelBytes().
  std::uint64_t allocatedBytes() const { return paddedTexelBytes(sizeBytes_); }
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

// Where a texel view may begin, bytes: the largest minTexelBufferOffsetAlignment that Vulkan allows.
inline constexpr std::uint64_t kTexelViewAlignment = 256;

// Of the formats that texel views have here.
std::uint64_t bytesPerTexel(VkFormat format);

// A typed window on a buffer, read with texelFetch.
class TexelView {
 public:
  TexelView() = default;
  // From an offset on, a multiple of kTexelViewAlignment: so many bytes, or all that there are; if that is more than
  // the device allows, as much as it allows.
  TexelView(const Context& context, const Buffer& buffer, VkFormat format, std::uint64_t offsetBytes = 0,
            std::uint64_t sizeBytes = 0);

  VkBufferView get() const { return view_.get(); }

 private:
  DeviceHandle<VkBufferView> view_;
};

// Copies host memory into a buffer and waits. Through a staging buffer of at most 64 MiB where the buffer is not
// mapped. May not overlap with work of the device on that buffer.
void upload(const Context& context, const Buffer& buffer, const void* data, std::uint64_t sizeBytes,
            std::uint64_t offsetBytes = 0);

// Fills a whole buffer piece by piece, without a copy of all of it on the host: fill(piece, offset) writes the bytes
// that belong at `offset`. Pieces are up to 64 MiB long and begin at multiples of that.
void uploadPieces(const Context& context, const Buffer& buffer,
                  const std::function<void(std::span<std::byte>, std::uint64_t)>& fill);

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

// A device buffer of `count` numbers, of which fill(numbers, first) writes some from the first-th on. Holds one of them
// where count is 0.
template <typename T, typename Fill>
Buffer makeBuffer(const Context& context, std::uint64_t count, const std::string& name, const Fill& fill) {
  static_assert((std::uint64_t{64} << 20) % sizeof(T) == 0, "a number in two pieces");
  Buffer buffer(context, count * sizeof(T), MemoryKind::Device, name);
  uploadPieces(context, buffer, [&](std::span<std::byte> piece, std::uint64_t offset) {
    const std::uint64_t first = offset / sizeof(T);
    fill(std::span(reinterpret_cast<T*>(piece.data()), std::min(piece.size() / sizeof(T), count - first)), first);
  });
  return buffer;
}

}  // namespace tetralux::gpu
