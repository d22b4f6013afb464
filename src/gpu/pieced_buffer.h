// A list in pieces: devices give memory in pieces of some GiB at most, and a mesh may be longer.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gpu/buffer.h"

namespace tetralux::gpu {

// Elements of a piece, as a power of two: 1 GiB of 32 bytes each, which nearly every device gives in one piece.
inline constexpr unsigned kPieceBits = 25;

// Shaders reach it by the address of a table: how many bits of an index count elements of a piece (uint, and four bytes
// of nothing), then the address of each piece.
class PiecedBuffer {
 public:
  PiecedBuffer() = default;
  // Throws Error(Device).
  //   elementBytes   of an element, a power of two of at most 64
  //   pieceBits      a piece has 2^pieceBits elements, the last one fewer; at most 31
  PiecedBuffer(const Context& context, std::uint64_t count, std::uint64_t elementBytes, unsigned pieceBits,
               const std::string& name);

  const std::vector<Buffer>& pieces() const { return pieces_; }
  // All there is, where there are no more elements than one piece has.
  const Buffer& firstPiece() const { return pieces_.front(); }
  VkDeviceAddress address() const { return table_.address(); }
  std::uint64_t sizeBytes() const;

 private:
  std::vector<Buffer> pieces_;  // at least one
  Buffer table_;
};

// As makeBuffer(): fill(numbers, first) writes some of `count` numbers from the first-th on.
template <typename T, typename Fill>
PiecedBuffer makePiecedBuffer(const Context& context, std::uint64_t count, unsigned pieceBits, const std::string& name,
                              const Fill& fill) {
  static_assert((std::uint64_t{64} << 20) % sizeof(T) == 0, "a number in two pieces");
  PiecedBuffer buffer(context, count, sizeof(T), pieceBits, name);
  for (size_t i = 0; i < buffer.pieces().size(); i++) {
    const std::uint64_t before = std::uint64_t{i} << pieceBits;
    uploadPieces(context, buffer.pieces()[i], [&](std::span<std::byte> bytes, std::uint64_t offset) {
      const std::uint64_t first = before + offset / sizeof(T);
      const std::uint64_t numbers = std::min<std::uint64_t>(bytes.size() / sizeof(T), count - first);
      fill(std::span(reinterpret_cast<T*>(bytes.data()), numbers), first);
    });
  }
  return buffer;
}

}  // namespace tetralux::gpu
