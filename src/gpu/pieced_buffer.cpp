#include "gpu/pieced_buffer.h"

#include <algorithm>

#include "base/check.h"

namespace tetralux::gpu {

PiecedBuffer::PiecedBuffer(const Context& context, std::uint64_t count, std::uint64_t elementBytes, unsigned pieceBits,
                           const std::string& name) {
  CHECK_LE(pieceBits, 31u);
  const std::uint64_t pieceCount = std::uint64_t{1} << pieceBits;
  std::vector<std::uint64_t> table = {pieceBits};
  std::uint64_t left = count;
  do {
    const std::uint64_t here = std::min(left, pieceCount);
    pieces_.emplace_back(context, here * elementBytes, MemoryKind::Device, name);
    table.push_back(pieces_.back().address());
    left -= here;
  } while (left > 0);
  table_ = makeBuffer(context, table, name + ", table of pieces");
}

std::uint64_t PiecedBuffer::sizeBytes() const {
  std::uint64_t bytes = table_.sizeBytes();
  for (const Buffer& piece : pieces_) bytes += piece.sizeBytes();
  return bytes;
}

}  // namespace tetralux::gpu
