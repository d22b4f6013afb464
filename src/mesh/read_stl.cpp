// Stereolithography files: triangles with three points of their own each.
#include <fmt/format.h>

#include <cstring>

#include "base/error.h"
#include "base/files.h"
#include "mesh/triangle_soup.h"
#include "mesh/vtk_assemble.h"
#include "mesh/vtk_text.h"
#include "mesh/vtk_types.h"

namespace tetralux {
namespace {

// A binary file: 80 bytes of anything, the number of triangles, and for each a normal, three points and two bytes more.
constexpr size_t kHeaderBytes = 84;
constexpr size_t kTriangleBytes = 50;

// A number of the file, which is little-endian.
template <typename T>
T numberAt(const std::string& file, size_t position) {
  T number;
  std::memcpy(&number, file.data() + position, sizeof number);
  if (kHostIsBigEndian) swapBytes(&number, 1, sizeof number);
  return number;
}

// Size that the header of a binary file stands for.
std::uint64_t binarySize(const std::string& file) {
  return kHeaderBytes + kTriangleBytes * std::uint64_t{numberAt<std::uint32_t>(file, kHeaderBytes - 4)};
}

void appendTriangle(TriangleSoup& soup) {
  const auto end = static_cast<std::uint32_t>(soup.points.size());
  soup.triangles.push_back({end - 3, end - 2, end - 1});
}

TriangleSoup readBinary(const std::string& file) {
  TriangleSoup soup;
  for (size_t at = kHeaderBytes; at < file.size(); at += kTriangleBytes) {
    for (size_t k = 1; k <= 3; k++) {
      const auto coordinate = [&](size_t axis) {
        return static_cast<double>(numberAt<float>(file, at + 4 * (3 * k + axis)));
      };
      soup.points.emplace_back(coordinate(0), coordinate(1), coordinate(2));
    }
    appendTriangle(soup);
  }
  return soup;
}

class TextReader {
 public:
  TextReader(const std::string& file, const std::string& name) : scanner_(file), name_(name) {}

  TriangleSoup read() {
    TriangleSoup soup;
    while (!scanner_.peekWord().empty()) {
      expect("solid");
      scanner_.line();  // its name
      while (lowerCase(scanner_.peekWord()) == "facet") readFacet(soup);
      expect("endsolid");
      scanner_.line();
    }
    return soup;
  }

 private:
  void readFacet(TriangleSoup& soup) {
    expect("facet");
    expect("normal");
    for (int i = 0; i < 3; i++) scanner_.word();  // the points say it better
    expect("outer");
    expect("loop");
    for (int k = 0; k < 3; k++) {
      expect("vertex");
      const double x = number();
      const double y = number();
      soup.points.emplace_back(x, y, number());
    }
    expect("endloop");
    expect("endfacet");
    checkPointCount(soup.points.size(), name_);
    appendTriangle(soup);
  }

  void expect(const char* word) {
    const std::string_view found = scanner_.word();
    if (lowerCase(found) != word) failAt(found, fmt::format("'{}'", word));
  }

  double number() {
    const std::string_view word = scanner_.word();
    double value = 0.0;
    if (!parseNumber(word, value)) failAt(word, "a number");
    return value;
  }

  [[noreturn]] void failAt(std::string_view found, const std::string& expected) const {
    if (found.empty()) fail(ErrorCode::Input, "{}: the file ends, expected {}", name_, expected);
    fail(ErrorCode::Input, "{}: line {}: '{}', expected {}", name_, scanner_.lineNumber(), excerpt(found), expected);
  }

  TextScanner scanner_;
  const std::string& name_;
};

}  // namespace

TriangleSoup readStl(const std::filesystem::path& path) {
  const std::string file = readTextFile(path);
  const std::string name = path.string();
  // Binary files may begin with "solid", too: their size tells.
  const bool hasHeader = file.size() >= kHeaderBytes;
  if (hasHeader && file.size() == binarySize(file)) return readBinary(file);
  if (lowerCase(TextScanner(file).peekWord()) == "solid") return TextReader(file, name).read();
  if (hasHeader)
    fail(ErrorCode::Input, "{}: {} bytes, expected {} for the {} triangles that it says it has", name, file.size(),
         binarySize(file), numberAt<std::uint32_t>(file, kHeaderBytes - 4));
  fail(ErrorCode::Input, "{}: {} bytes that begin with '{}', expected 'solid', or the {} bytes of a binary header",
       name, file.size(), excerpt(std::string_view(file).substr(0, 8)), kHeaderBytes);
}

}  // namespace tetralux
