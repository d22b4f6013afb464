#include "mesh/vtk_packed_array.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "mesh/vtk_types.h"

namespace tetralux {
namespace {

struct Block {
  size_t begin;  // in the compressed bytes
  size_t size;
};

// The header of a compressed array, checked: `blocks` decompress to `fullSize` bytes each, the last one to `lastSize`,
// altogether as many as asked for.
struct BlockTable {
  std::vector<Block> blocks;
  size_t fullSize = 0;
  size_t lastSize = 0;
  size_t compressedSize = 0;

  size_t decompressedSize(size_t block) const { return block + 1 == blocks.size() ? lastSize : fullSize; }
};

std::vector<std::uint64_t> readHeader(VtkByteSource& source, const VtkPacking& packing, size_t count,
                                      std::string_view place) {
  // A block's size takes a header number: more of them than bytes is damage, not a reason to take memory.
  if (count > source.available() / packing.headerSize)
    fail(ErrorCode::Input, "{}: header of {} x {} bytes, expected no more than the {} bytes of data left", place, count,
         packing.headerSize, source.available());
  std::vector<std::byte> bytes(count * packing.headerSize);
  source.read(bytes, place);
  if (packing.swapBytes) swapBytes(bytes.data(), count, packing.headerSize);
  std::vector<std::uint64_t> numbers(count);
  for (size_t i = 0; i < count; i++) {
    if (packing.headerSize == 8) {
      std::memcpy(&numbers[i], &bytes[i * 8], 8);
    } else {
      std::uint32_t number = 0;
      std::memcpy(&number, &bytes[i * 4], 4);
      numbers[i] = number;
    }
  }
  return numbers;
}

BlockTable readBlockTable(VtkByteSource& source, const VtkPacking& packing, size_t expected, std::string_view place) {
  const std::vector<std::uint64_t> sizes = readHeader(source, packing, 3, place);
  const std::uint64_t count = sizes[0], fullSize = sizes[1], partialSize = sizes[2];
  // Divided, not multiplied: no product of untrusted numbers that could overflow.
  const std::uint64_t lastSize = partialSize != 0 ? partialSize : fullSize;
  const bool sizesAgree = count == 0 ? expected == 0
                                     : fullSize != 0 && lastSize <= fullSize && lastSize <= expected &&
                                           (expected - lastSize) % fullSize == 0 &&
                                           (expected - lastSize) / fullSize == count - 1;
  if (!sizesAgree)
    fail(ErrorCode::Input, "{}: {} compressed blocks of {} bytes, the last of {}, expected {} bytes in all", place,
         count, fullSize, lastSize, expected);
  BlockTable table;
  table.fullSize = fullSize;
  table.lastSize = lastSize;
  for (const std::uint64_t size : readHeader(source, packing, count, place)) {
    if (size > source.available() - table.compressedSize)
      fail(ErrorCode::Input, "{}: block {} has {} compressed bytes, expected no more than the {} bytes of data left",
           place, table.blocks.size(), size, source.available() - table.compressedSize);
    table.blocks.push_back({table.compressedSize, size});
    table.compressedSize += size;
  }
  for (size_t i = 0; i < table.blocks.size(); i++) {
    if (table.decompressedSize(i) > largestDecompressedSize(packing.compressor, table.blocks[i].size))
      fail(ErrorCode::Input, "{}: block {} has {} compressed bytes, expected enough for {} decompressed ones", place, i,
           table.blocks[i].size, table.decompressedSize(i));
  }
  return table;
}

void decompressAll(const BlockTable& table, VtkCompressor compressor, std::span<const std::byte> compressed,
                   std::span<std::byte> out, std::string_view place) {
  constexpr size_t kBlocksAtOnce = 4;
  parallelFor(table.blocks.size(), kBlocksAtOnce, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++) {
      const Block& block = table.blocks[i];
      if (!decompressBlock(compressor, compressed.subspan(block.begin, block.size),
                           out.subspan(i * table.fullSize, table.decompressedSize(i))))
        fail(ErrorCode::Input, "{}: block {} is damaged, expected {} data of {} bytes", place, i,
             compressorName(compressor), table.decompressedSize(i));
    }
  });
}

}  // namespace

size_t VtkByteSource::available() const {
  if (const auto* raw = std::get_if<0>(&source_)) return raw->size();
  return std::get<1>(source_).available();
}

void VtkByteSource::read(std::span<std::byte> out, std::string_view place) {
  if (auto* raw = std::get_if<0>(&source_)) {
    if (raw->size() < out.size())
      fail(ErrorCode::Input, "{}: data ends after {} bytes, expected {}", place, raw->size(), out.size());
    std::copy_n(raw->begin(), out.size(), out.begin());
    *raw = raw->subspan(out.size());
    return;
  }
  Base64Reader& base64 = std::get<1>(source_);
  const size_t got = base64.read(out.data(), out.size());
  if (got == out.size()) return;
  if (!base64.atEnd())
    fail(ErrorCode::Input, "{}: character {} of the data is not base64, expected {} more bytes", place,
         base64.position(), out.size() - got);
  fail(ErrorCode::Input, "{}: data ends after {} bytes, expected {}", place, got, out.size());
}

std::span<const std::byte> VtkByteSource::take(size_t count, std::vector<std::byte>& storage, std::string_view place) {
  if (auto* raw = std::get_if<0>(&source_); raw && count <= raw->size()) {
    const std::span<const std::byte> taken = raw->first(count);
    *raw = raw->subspan(count);
    return taken;
  }
  storage.resize(std::min(count, available()));
  if (storage.size() < count)
    fail(ErrorCode::Input, "{}: data has at most {} bytes, expected {}", place, storage.size(), count);
  read(storage, place);
  return storage;
}

void unpackNumbers(VtkByteSource source, const VtkPacking& packing, size_t count, std::string_view place,
                   ArrayValues& values) {
  const size_t expected = count * numberSize(values);
  const auto resized = [&]() -> std::span<std::byte> {
    return std::visit(
        [count](auto& v) {
          v.resize(count);
          return std::as_writable_bytes(std::span(v));
        },
        values);
  };
  if (packing.compressor == VtkCompressor::None) {
    const std::uint64_t size = readHeader(source, packing, 1, place)[0];
    if (size != expected)
      fail(ErrorCode::Input, "{}: data has {} bytes, expected {} for {} numbers", place, size, expected, count);
    if (expected > source.available())
      fail(ErrorCode::Input, "{}: data ends after {} bytes, expected {}", place, source.available(), expected);
    source.read(resized(), place);
  } else {
    const BlockTable table = readBlockTable(source, packing, expected, place);
    std::vector<std::byte> decoded;
    const std::span<const std::byte> compressed = source.take(table.compressedSize, decoded, place);
    decompressAll(table, packing.compressor, compressed, resized(), place);
  }
  if (packing.swapBytes) std::visit([&](auto& v) { swapBytes(v.data(), count, numberSize(values)); }, values);
}

}  // namespace tetralux
