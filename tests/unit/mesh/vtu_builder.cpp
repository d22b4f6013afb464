#include "unit/mesh/vtu_builder.h"

#include <fmt/format.h>
#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

namespace tetralux::test {
namespace {

void require(bool condition, const char* what) {
  if (!condition) throw std::runtime_error(what);
}

std::string compressed(const std::string& block, Compression compression) {
  std::string out(block.size() * 2 + 1000, '\0');
  auto* to = reinterpret_cast<std::uint8_t*>(out.data());
  const auto* from = reinterpret_cast<const std::uint8_t*>(block.data());
  size_t size = 0;
  if (compression == Compression::ZLib) {
    uLongf bytes = out.size();
    require(compress2(to, &bytes, from, block.size(), 5) == Z_OK, "zlib");
    size = bytes;
  } else if (compression == Compression::Lz4) {
    size = static_cast<size_t>(
        LZ4_compress_default(block.data(), out.data(), static_cast<int>(block.size()), static_cast<int>(out.size())));
    require(size > 0, "lz4");
  } else {
    require(lzma_easy_buffer_encode(1, LZMA_CHECK_CRC32, nullptr, from, block.size(), to, &size, out.size()) == LZMA_OK,
            "lzma");
  }
  out.resize(size);
  return out;
}

class Builder {
 public:
  explicit Builder(const VtuFormat& format) : format_(format) {}

  std::string build(const std::vector<TetMesh>& pieces) {
    constexpr const char* kCompressors[] = {"", " compressor=\"vtkZLibDataCompressor\"",
                                            " compressor=\"vtkLZ4DataCompressor\"",
                                            " compressor=\"vtkLZMADataCompressor\""};
    text_ += fmt::format("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" header_type=\"{}\"{}>\n",
                         format_.bigEndian ? "BigEndian" : "LittleEndian", format_.header64 ? "UInt64" : "UInt32",
                         kCompressors[static_cast<int>(format_.compression)]);
    text_ += "  <UnstructuredGrid>\n";
    for (const TetMesh& mesh : pieces) addPiece(mesh);
    text_ += "  </UnstructuredGrid>\n";
    if (format_.placement == Placement::AppendedRaw || format_.placement == Placement::AppendedBase64) {
      text_ += fmt::format("  <AppendedData encoding=\"{}\">\n   _",
                           format_.placement == Placement::AppendedRaw ? "raw" : "base64");
      text_ += appended_ + "\n  </AppendedData>\n";
    }
    return text_ + "</VTKFile>\n";
  }

 private:
  void addPiece(const TetMesh& mesh) {
    text_ +=
        fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", mesh.pointCount(), mesh.cellCount());
    addGroup("PointData", mesh.pointArrays, mesh.preferredField);
    addGroup("CellData", mesh.cellArrays, mesh.preferredField);
    text_ += "      <Points>\n";
    std::vector<double> coordinates;
    for (size_t i = 0; i < mesh.pointCount(); i++) {
      for (int axis = 0; axis < 3; axis++) coordinates.push_back(mesh.point(i)[axis]);
    }
    addArray("Points", 3, convertedTo(format_.coordinateType, coordinates));
    text_ += "      </Points>\n      <Cells>\n";
    std::vector<std::uint32_t> vertices, ends;
    for (const CellVertices& cell : mesh.cells) {
      vertices.insert(vertices.end(), cell.begin(), cell.end());
      ends.push_back(static_cast<std::uint32_t>(vertices.size()));
    }
    addArray("connectivity", 1, convertedTo(format_.indexType, vertices));
    addArray("offsets", 1, convertedTo(format_.indexType, ends));
    addArray("types", 1, std::vector<std::uint8_t>(mesh.cellCount(), 10));
    text_ += "      </Cells>\n    </Piece>\n";
  }

  void addGroup(const char* group, const std::vector<DataArray>& arrays, const std::string& preferred) {
    const bool active = std::any_of(arrays.begin(), arrays.end(), [&](const auto& a) { return a.name == preferred; });
    text_ += active ? fmt::format("      <{} Scalars=\"{}\">\n", group, preferred) : fmt::format("      <{}>\n", group);
    for (const DataArray& a : arrays) addArray(a.name, a.components, a.values);
    text_ += fmt::format("      </{}>\n", group);
  }

  void addArray(const std::string& name, std::uint32_t components, ArrayValues values) {
    if (format_.editValues) format_.editValues(name, values);
    text_ += fmt::format("        <DataArray type=\"{}\" Name=\"{}\"", DataArray{{}, 1, values}.typeName(), name);
    if (components != 1) text_ += fmt::format(" NumberOfComponents=\"{}\"", components);
    if (format_.placement == Placement::Ascii) {
      text_ += fmt::format(" format=\"ascii\">\n          {}\n        </DataArray>\n", numberText(values));
    } else if (format_.placement == Placement::Inline) {
      text_ += fmt::format(" format=\"binary\">\n          {}\n        </DataArray>\n", packed(name, values));
    } else {
      text_ += fmt::format(" format=\"appended\" offset=\"{}\"/>\n", appended_.size());
      appended_ += packed(name, values);
    }
  }

  // Header and data: bytes, or one base64 run, or two where blocks are compressed.
  std::string packed(const std::string& name, const ArrayValues& values) {
    const std::string plain = numberBytes(values, format_.bigEndian);
    std::vector<std::uint64_t> header = {plain.size()};
    std::string data = plain;
    if (format_.compression != Compression::None) {
      header = {(plain.size() + format_.blockSize - 1) / format_.blockSize, format_.blockSize,
                plain.size() % format_.blockSize};
      data.clear();
      for (size_t begin = 0; begin < plain.size(); begin += format_.blockSize) {
        const std::string block = compressed(plain.substr(begin, format_.blockSize), format_.compression);
        header.push_back(block.size());
        data += block;
      }
    }
    if (format_.editHeader) format_.editHeader(name, header);
    if (format_.editBytes) format_.editBytes(name, data);
    std::string headerBytes = numberBytes(header, format_.bigEndian);
    if (!format_.header64)
      headerBytes = numberBytes(std::vector<std::uint32_t>(header.begin(), header.end()), format_.bigEndian);
    if (format_.placement == Placement::AppendedRaw) return headerBytes + data;
    std::string text = format_.compression == Compression::None ? encodeBase64(headerBytes + data)
                                                                : encodeBase64(headerBytes) + encodeBase64(data);
    for (size_t at = 20; format_.lineBreaks && at < text.size(); at += 22) text.insert(at, "\r\n");
    return text;
  }

  const VtuFormat& format_;
  std::string text_;
  std::string appended_;
};

}  // namespace

std::string buildVtu(const std::vector<TetMesh>& pieces, const VtuFormat& format) {
  return Builder(format).build(pieces);
}

std::string buildVtu(const TetMesh& mesh, const VtuFormat& format) { return buildVtu(std::vector{mesh}, format); }

ArrayValues convertedTo(const ArrayValues& type, const ArrayValues& values) {
  return std::visit(
      [](auto to, const auto& from) -> ArrayValues {
        using T = typename decltype(to)::value_type;
        to.clear();
        for (const auto& number : from) to.push_back(static_cast<T>(number));
        return to;
      },
      type, values);
}

std::string numberBytes(const ArrayValues& values, bool bigEndian) {
  return std::visit(
      [&](const auto& v) {
        const size_t width = sizeof(typename std::decay_t<decltype(v)>::value_type);
        std::string bytes(v.size() * width, '\0');
        if (!v.empty()) std::memcpy(bytes.data(), v.data(), bytes.size());
        if (bigEndian == (std::endian::native == std::endian::big)) return bytes;
        for (size_t i = 0; i < bytes.size(); i += width) {
          std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                       bytes.begin() + static_cast<std::ptrdiff_t>(i + width));
        }
        return bytes;
      },
      values);
}

std::string numberText(const ArrayValues& values) {
  return std::visit(
      [](const auto& v) {
        std::string text;
        for (size_t i = 0; i < v.size(); i++) text += fmt::format("{}{}", i == 0 ? "" : i % 6 == 0 ? "\n" : " ", v[i]);
        return text;
      },
      values);
}

std::string encodeBase64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (size_t k = 0; k < 3; k++)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0);
    for (size_t k = 0; k < 4; k++) text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

}  // namespace tetralux::test
