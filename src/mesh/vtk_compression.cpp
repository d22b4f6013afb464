#include "mesh/vtk_compression.h"

#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include <limits>

namespace tetralux {
namespace {

bool decompressZLib(std::span<const std::byte> in, std::span<std::byte> out) {
  uLongf outSize = out.size();
  uLong inSize = in.size();
  const int result =
      uncompress2(reinterpret_cast<Bytef*>(out.data()), &outSize, reinterpret_cast<const Bytef*>(in.data()), &inSize);
  return result == Z_OK && outSize == out.size();
}

bool decompressLz4(std::span<const std::byte> in, std::span<std::byte> out) {
  constexpr size_t kMost = std::numeric_limits<int>::max();
  if (in.size() > kMost || out.size() > kMost) return false;
  const int size = LZ4_decompress_safe(reinterpret_cast<const char*>(in.data()), reinterpret_cast<char*>(out.data()),
                                       static_cast<int>(in.size()), static_cast<int>(out.size()));
  return size >= 0 && static_cast<size_t>(size) == out.size();
}

bool decompressLzma(std::span<const std::byte> in, std::span<std::byte> out) {
  // Enough for every preset (the largest has a dictionary of 64 MiB); a file's header may ask for 4 GiB.
  std::uint64_t memoryLimit = std::uint64_t{128} << 20;
  size_t inPosition = 0;
  size_t outPosition = 0;
  const lzma_ret result =
      lzma_stream_buffer_decode(&memoryLimit, 0, nullptr, reinterpret_cast<const std::uint8_t*>(in.data()), &inPosition,
                                in.size(), reinterpret_cast<std::uint8_t*>(out.data()), &outPosition, out.size());
  return result == LZMA_OK && outPosition == out.size();
}

}  // namespace

std::optional<VtkCompressor> compressorNamed(std::string_view name) {
  if (name.empty()) return VtkCompressor::None;
  if (name == "vtkZLibDataCompressor") return VtkCompressor::ZLib;
  if (name == "vtkLZ4DataCompressor") return VtkCompressor::Lz4;
  if (name == "vtkLZMADataCompressor") return VtkCompressor::Lzma;
  return std::nullopt;
}

const char* compressorName(VtkCompressor compressor) {
  switch (compressor) {
    case VtkCompressor::ZLib:
      return "zlib";
    case VtkCompressor::Lz4:
      return "LZ4";
    case VtkCompressor::Lzma:
      return "LZMA";
    default:
      return "no";
  }
}

std::uint64_t largestDecompressedSize(VtkCompressor compressor, std::uint64_t compressed) {
  std::uint64_t ratio = 1;
  // Deflate: a match of 258 bytes takes two bits at least.
  if (compressor == VtkCompressor::ZLib) ratio = 1032;
  // LZ4: every byte of a match's length adds 255.
  if (compressor == VtkCompressor::Lz4) ratio = 255;
  // LZMA: a match of 273 bytes is 14 coded decisions of log2(2048/2017) bits at least, 7091 to 1.
  if (compressor == VtkCompressor::Lzma) ratio = 7092;
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  return compressed > most / ratio ? most : compressed * ratio;
}

bool decompressBlock(VtkCompressor compressor, std::span<const std::byte> in, std::span<std::byte> out) {
  switch (compressor) {
    case VtkCompressor::ZLib:
      return decompressZLib(in, out);
    case VtkCompressor::Lz4:
      return decompressLz4(in, out);
    case VtkCompressor::Lzma:
      return decompressLzma(in, out);
    default:
      return false;
  }
}

}  // namespace tetralux
