// VTK XML unstructured grids (.vtu): appended raw data.
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <span>

#include "base/check.h"
#include "base/error.h"
#include "base/files.h"
#include "base/parallel.h"
#include "base/xml_text.h"
#include "mesh/mesh_io.h"
#include "mesh/vtk_types.h"

namespace tetralux {
namespace {

constexpr size_t kBlockSize = 32 << 10;
constexpr size_t kBlocksAtOnce = 256;  // 8 MiB
// The smallest file of all zlib's levels for the indices of tetrahedra, which are most of a file, and four times as
// fast as 6, its default (20 MB of them on one core: level 1 116 ms, 5.4 MB; 4 177 ms, 4.9 MB; 6 702 ms, 5.5 MB).
constexpr int kLevel = 4;

// An array as the file holds it. Its bytes are made block by block: those of a large mesh's connectivity or offsets
// never exist as a whole.
struct FileArray {
  std::string attributes;  // of the DataArray element, but for format and offset
  size_t size = 0;         // bytes
  std::function<void(size_t begin, std::span<std::byte> out)> copy;  // whole numbers, from byte `begin` on
  std::uint64_t offset = 0;                                          // in the appended data, once written
};

struct FileLayout {
  std::vector<FileArray> pointArrays, cellArrays;
  FileArray points, connectivity, offsets, types;
};

// An array that is in memory as the file holds it.
FileArray storedArray(std::string attributes, const void* data, size_t size) {
  const auto* bytes = static_cast<const std::byte*>(data);
  return {std::move(attributes), size,
          [bytes](size_t begin, std::span<std::byte> out) { std::copy_n(bytes + begin, out.size(), out.begin()); }};
}

// `count` numbers of type T, number(i) each.
template <typename T, typename Number>
FileArray computedArray(std::string attributes, size_t count, Number number) {
  return {std::move(attributes), count * sizeof(T), [number](size_t begin, std::span<std::byte> out) {
            for (size_t i = 0; i < out.size() / sizeof(T); i++) {
              const T value = static_cast<T>(number(begin / sizeof(T) + i));
              std::memcpy(&out[i * sizeof(T)], &value, sizeof(T));
            }
          }};
}

// Indices up to `largest`, in the type that VTK would read with the least memory.
template <typename Number>
FileArray indexArray(const char* name, size_t count, std::uint64_t largest, Number number) {
  if (largest <= std::numeric_limits<std::int32_t>::max())
    return computedArray<std::int32_t>(fmt::format("type=\"Int32\" Name=\"{}\"", name), count, number);
  return computedArray<std::int64_t>(fmt::format("type=\"Int64\" Name=\"{}\"", name), count, number);
}

FileArray fileArray(const DataArray& array) {
  return std::visit(
      [&](const auto& v) {
        return storedArray(fmt::format("type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"", array.typeName(),
                                       escapedXml(array.name), array.components),
                           v.data(), array.sizeBytes());
      },
      array.values);
}

FileLayout layoutOf(const TetMesh& mesh) {
  FileLayout layout;
  for (const DataArray& array : mesh.pointArrays) layout.pointArrays.push_back(fileArray(array));
  for (const DataArray& array : mesh.cellArrays) layout.cellArrays.push_back(fileArray(array));
  std::visit(
      [&](const auto& p) {
        using Point = typename std::decay_t<decltype(p)>::value_type;
        static_assert(sizeof(Point) == 3 * sizeof(typename Point::value_type));
        layout.points = storedArray(fmt::format("type=\"Float{}\" Name=\"Points\" NumberOfComponents=\"3\"",
                                                8 * sizeof(typename Point::value_type)),
                                    p.data(), p.size() * sizeof(Point));
      },
      mesh.points);
  const std::vector<CellVertices>& cells = mesh.cells;
  layout.connectivity = indexArray("connectivity", 4 * cells.size(), mesh.pointCount(),
                                   [&cells](size_t i) { return cells[i / 4][i % 4]; });
  layout.offsets =
      indexArray("offsets", cells.size(), 4 * std::uint64_t{cells.size()}, [](size_t i) { return 4 * (i + 1); });
  layout.types = computedArray<std::uint8_t>("type=\"UInt8\" Name=\"types\"", cells.size(),
                                             [](size_t) { return kTetrahedronType; });
  return layout;
}

// The XML before the appended data. Its length does not depend on the offsets, so it can be written again once they
// are known.
std::string headOf(const FileLayout& layout, const TetMesh& mesh, bool compress) {
  std::string head = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" "
      "header_type=\"UInt64\"{}>\n  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
      kHostIsBigEndian ? "BigEndian" : "LittleEndian", compress ? " compressor=\"vtkZLibDataCompressor\"" : "",
      mesh.pointCount(), mesh.cellCount());
  const auto addArray = [&](const FileArray& array) {
    fmt::format_to(std::back_inserter(head), "        <DataArray {} format=\"appended\" offset=\"{:<20}\"/>\n",
                   array.attributes, array.offset);
  };
  const auto names = [&](const DataArray& a) { return a.name == mesh.preferredField; };
  const bool atPoints = std::any_of(mesh.pointArrays.begin(), mesh.pointArrays.end(), names);
  const bool inCells = !atPoints && std::any_of(mesh.cellArrays.begin(), mesh.cellArrays.end(), names);
  const std::string scalars =
      mesh.preferredField.empty() ? "" : fmt::format(" Scalars=\"{}\"", escapedXml(mesh.preferredField));
  head += fmt::format("      <PointData{}>\n", atPoints ? scalars : "");
  for (const FileArray& array : layout.pointArrays) addArray(array);
  head += fmt::format("      </PointData>\n      <CellData{}>\n", inCells ? scalars : "");
  for (const FileArray& array : layout.cellArrays) addArray(array);
  head += "      </CellData>\n      <Points>\n";
  addArray(layout.points);
  head += "      </Points>\n      <Cells>\n";
  for (const FileArray* array : {&layout.connectivity, &layout.offsets, &layout.types}) addArray(*array);
  head += "      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n   _";
  return head;
}

// A file that is written from front to back, but for parts that are filled in later.
class OutputStream {
 public:
  OutputStream(const std::filesystem::path& temporary, std::string name)
      : name_(std::move(name)), file_(std::fopen(temporary.c_str(), "wb")) {
    if (!file_) failed();
  }

  void write(const void* bytes, size_t size) {
    if (size != 0 && std::fwrite(bytes, 1, size, file_.get()) != size) failed();
    position_ += size;
  }

  // Writes over what is at `position` and returns to the end.
  void overwrite(std::uint64_t position, const void* bytes, size_t size) {
    const std::uint64_t end = position_;
    seek(position);
    write(bytes, size);
    seek(end);
  }

  void close() {
    if (std::fclose(file_.release()) != 0) failed();
  }

  std::uint64_t position() const { return position_; }

 private:
  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };

  void seek(std::uint64_t position) {
    if (fseeko(file_.get(), static_cast<off_t>(position), SEEK_SET) != 0) failed();
    position_ = position;
  }

  [[noreturn]] void failed() { fail(ErrorCode::Output, "{}: cannot be written: {}", name_, std::strerror(errno)); }

  std::string name_;
  std::unique_ptr<std::FILE, Close> file_;
  std::uint64_t position_ = 0;
};

void writePlain(OutputStream& out, const FileArray& array) {
  const std::uint64_t size = array.size;
  out.write(&size, sizeof size);
  std::vector<std::byte> bytes(std::min(array.size, kBlocksAtOnce * kBlockSize));
  for (size_t begin = 0; begin < array.size; begin += bytes.size()) {
    const auto part = std::span(bytes).first(std::min(bytes.size(), array.size - begin));
    array.copy(begin, part);
    out.write(part.data(), part.size());
  }
}

void writeCompressed(OutputStream& out, const FileArray& array) {
  const size_t blocks = (array.size + kBlockSize - 1) / kBlockSize;
  std::vector<std::uint64_t> header = {blocks, kBlockSize, array.size % kBlockSize};
  header.resize(3 + blocks);
  const std::uint64_t headerPosition = out.position();
  const size_t headerBytes = header.size() * sizeof header[0];
  out.write(header.data(), headerBytes);
  std::vector<std::vector<Bytef>> compressed(std::min(blocks, kBlocksAtOnce));
  for (size_t first = 0; first < blocks; first += kBlocksAtOnce) {
    const size_t count = std::min(kBlocksAtOnce, blocks - first);
    parallelFor(count, 4, [&](size_t begin, size_t end, unsigned) {
      std::vector<std::byte> plain(kBlockSize);
      for (size_t i = begin; i < end; i++) {
        const size_t at = (first + i) * kBlockSize;
        const auto part = std::span(plain).first(std::min(kBlockSize, array.size - at));
        array.copy(at, part);
        uLongf size = compressBound(part.size());
        compressed[i].resize(size);
        CHECK_EQ(
            compress2(compressed[i].data(), &size, reinterpret_cast<const Bytef*>(part.data()), part.size(), kLevel),
            Z_OK);
        compressed[i].resize(size);
      }
    });
    for (size_t i = 0; i < count; i++) {
      header[3 + first + i] = compressed[i].size();
      out.write(compressed[i].data(), compressed[i].size());
    }
  }
  out.overwrite(headerPosition, header.data(), headerBytes);
}

}  // namespace

void writeVtu(const TetMesh& mesh, const std::filesystem::path& path, const VtuWriteOptions& options) {
  FileLayout layout = layoutOf(mesh);
  PendingFile pending(path);
  OutputStream out(pending.temporaryPath(), path.string());
  const std::string placeholder = headOf(layout, mesh, options.compress);
  out.write(placeholder.data(), placeholder.size());
  const auto writeArray = [&](FileArray& array) {
    array.offset = out.position() - placeholder.size();
    if (options.compress)
      writeCompressed(out, array);
    else
      writePlain(out, array);
  };
  for (FileArray& array : layout.pointArrays) writeArray(array);
  for (FileArray& array : layout.cellArrays) writeArray(array);
  for (FileArray* array : {&layout.points, &layout.connectivity, &layout.offsets, &layout.types}) writeArray(*array);
  constexpr std::string_view kTail = "\n  </AppendedData>\n</VTKFile>\n";
  out.write(kTail.data(), kTail.size());
  const std::string head = headOf(layout, mesh, options.compress);
  CHECK_EQ(head.size(), placeholder.size());
  out.overwrite(0, head.data(), head.size());
  out.close();
  pending.commit();
}

}  // namespace tetralux
