// Writes VTU text in every encoding, independently of what it tests.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mesh/tet_mesh.h"

namespace tetralux::test {

enum class Placement { Ascii, Inline, AppendedRaw, AppendedBase64 };
enum class Compression { None, ZLib, Lz4, Lzma };

struct VtuFormat {
  Placement placement = Placement::Ascii;
  Compression compression = Compression::None;
  bool bigEndian = false;
  bool header64 = false;
  size_t blockSize = 32;
  ArrayValues indexType = std::vector<std::int64_t>();  // of connectivity and offsets
  ArrayValues coordinateType = std::vector<float>();
  bool lineBreaks = false;  // inside base64 text

  // Changes an array's header before it is written: its number of bytes, or number of blocks, size of a block, size of
  // a partial last block, compressed sizes.
  std::function<void(const std::string& array, std::vector<std::uint64_t>& header)> editHeader;
  // Changes an array's bytes after the header.
  std::function<void(const std::string& array, std::string& bytes)> editBytes;
  // Changes the numbers of an array before they are written.
  std::function<void(const std::string& array, ArrayValues& values)> editValues;
};

// The file's text: one piece for each mesh.
std::string buildVtu(const std::vector<TetMesh>& pieces, const VtuFormat& format);
std::string buildVtu(const TetMesh& mesh, const VtuFormat& format);

// The same numbers in the type of `type`.
ArrayValues convertedTo(const ArrayValues& type, const ArrayValues& values);

// Numbers as bytes in the given order.
std::string numberBytes(const ArrayValues& values, bool bigEndian);

// Numbers as text that gives the same numbers again.
std::string numberText(const ArrayValues& values);

std::string encodeBase64(const std::string& bytes);

}  // namespace tetralux::test
