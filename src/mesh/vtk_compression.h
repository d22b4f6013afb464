// The compressors of VTK's XML formats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tetralux {

enum class VtkCompressor { None, ZLib, Lz4, Lzma };

// By the class name in the file's `compressor` attribute; an empty name is None, an unknown one nothing.
std::optional<VtkCompressor> compressorNamed(std::string_view name);

// "zlib", "LZ4", "LZMA" or "no"
const char* compressorName(VtkCompressor compressor);

// Most bytes that `compressed` bytes can stand for. What a file claims beyond it is wrong and need not be allocated.
std::uint64_t largestDecompressedSize(VtkCompressor compressor, std::uint64_t compressed);

// Decompresses one block. False unless it holds exactly out.size() bytes.
//   compressor   not None
bool decompressBlock(VtkCompressor compressor, std::span<const std::byte> in, std::span<std::byte> out);

}  // namespace tetralux
