// Binary arrays of VTK's XML formats: a header, then the numbers, plain or in compressed blocks.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "mesh/base64.h"
#include "mesh/data_array.h"
#include "mesh/vtk_compression.h"

namespace tetralux {

// How a file packs its arrays: the same for all of them.
struct VtkPacking {
  bool swapBytes = false;  // the file's byte order is not the host's
  size_t headerSize = 4;   // bytes of a header's number, 4 or 8
  VtkCompressor compressor = VtkCompressor::None;
};

// The bytes of an array in the file: as they are, or base64 text.
class VtkByteSource {
 public:
  explicit VtkByteSource(std::span<const std::byte> raw) : source_(raw) {}
  explicit VtkByteSource(std::string_view base64) : source_(Base64Reader(base64)) {}

  // Upper bound of the bytes that are left; exact for raw bytes.
  size_t available() const;

  // Takes the next out.size() bytes. Throws Error(Input), beginning with `place`, when there are fewer.
  void read(std::span<std::byte> out, std::string_view place);

  // Takes the next `count` bytes: a view of raw bytes, or of `storage` after decoding. Throws like read().
  std::span<const std::byte> take(size_t count, std::vector<std::byte>& storage, std::string_view place);

 private:
  std::variant<std::span<const std::byte>, Base64Reader> source_;
};

// Replaces `values` by `count` numbers of its type, unpacked from `source`; compressed blocks in parallel.
// Throws Error(Input), beginning with `place`, where the source holds fewer or its header says otherwise. Memory is
// taken only for as many numbers as the bytes at hand can stand for.
void unpackNumbers(VtkByteSource source, const VtkPacking& packing, size_t count, std::string_view place,
                   ArrayValues& values);

}  // namespace tetralux
