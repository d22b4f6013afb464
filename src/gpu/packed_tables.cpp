#include "gpu/packed_tables.h"

#include <cstring>

#include "base/check.h"

namespace tetralux::gpu {

void PackedTables::set(const Context& context, std::span<const TableView> tables, const std::string& name) {
  const auto aligned = [](std::uint64_t bytes) {
    return (bytes + kTexelViewAlignment - 1) / kTexelViewAlignment * kTexelViewAlignment;
  };
  std::vector<std::uint64_t> offsets;
  std::uint64_t end = 0;
  for (const TableView& table : tables) {
    CHECK(!table.bytes.empty());
    offsets.push_back(end);
    end += aligned(table.bytes.size());
    *table.view = {};
  }
  std::vector<std::byte> packed(end);
  for (size_t i = 0; i < tables.size(); i++)
    std::memcpy(packed.data() + offsets[i], tables[i].bytes.data(), tables[i].bytes.size());
  if (end > buffer_.sizeBytes()) {
    buffer_ = {};  // both may not fit
    buffer_ = Buffer(context, end, MemoryKind::Device, name);
  }
  upload(context, buffer_, packed.data(), packed.size());
  for (size_t i = 0; i < tables.size(); i++)
    *tables[i].view = TexelView(context, buffer_, tables[i].format, offsets[i], tables[i].bytes.size());
}

}  // namespace tetralux::gpu
