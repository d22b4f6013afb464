// Several small tables that shaders read, in one buffer.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "gpu/buffer.h"

namespace tetralux::gpu {

// A table to be packed, and the view that is to show it.
struct TableView {
  TexelView* view = nullptr;
  VkFormat format = VK_FORMAT_UNDEFINED;
  std::span<const std::byte> bytes;  // whole texels, at least one
};

template <typename T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

// Views are as long as their tables: shaders may ask for their size. Replacing tables takes one copy; memory is taken
// from the device only where they are longer than any before, since that takes drivers many times as long.
class PackedTables {
 public:
  // Copies the tables to the device and makes their views anew. Work that reads what was there before must be over.
  // Throws Error(Device).
  //   name   shown in messages
  void set(const Context& context, std::span<const TableView> tables, const std::string& name);

  std::uint64_t sizeBytes() const { return buffer_.sizeBytes(); }

 private:
  Buffer buffer_;
};

}  // namespace tetralux::gpu
