// Stanford .ply files: elements with properties as their header describes them.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>

#include "base/error.h"
#include "base/files.h"
#include "mesh/triangle_soup.h"
#include "mesh/vtk_assemble.h"
#include "mesh/vtk_text.h"
#include "mesh/vtk_types.h"

namespace tetralux {
namespace {

struct Property {
  std::string name;
  ArrayValues type;                      // empty, of its numbers' type
  std::optional<ArrayValues> countType;  // of a list
};

struct Element {
  std::string name;
  size_t count = 0;
  std::vector<Property> properties;
};

// Empty values of a type by either of its names.
std::optional<ArrayValues> typeNamed(std::string_view name) {
  if (name == "char" || name == "int8") return std::vector<std::int8_t>();
  if (name == "uchar" || name == "uint8") return std::vector<std::uint8_t>();
  if (name == "short" || name == "int16") return std::vector<std::int16_t>();
  if (name == "ushort" || name == "uint16") return std::vector<std::uint16_t>();
  if (name == "int" || name == "int32") return std::vector<std::int32_t>();
  if (name == "uint" || name == "uint32") return std::vector<std::uint32_t>();
  if (name == "float" || name == "float32") return std::vector<float>();
  if (name == "double" || name == "float64") return std::vector<double>();
  return std::nullopt;
}

class PlyReader {
 public:
  explicit PlyReader(const std::filesystem::path& path)
      : name_(path.string()), file_(readTextFile(path)), scanner_(file_) {}

  TriangleSoup read() {
    readHeader();
    for (const Element& element : elements_) {
      if (element.name == "vertex")
        readPoints(element);
      else if (element.name == "face")
        readFaces(element);
      else
        passOver(element);
    }
    const std::string_view rest = scanner_.word();
    if (!rest.empty())
      fail(ErrorCode::Input, "{}: '{}' after the last element, expected the file's end", name_, excerpt(rest));
    for (size_t i = 0; i < faces_.size(); i++)
      appendPolygon(soup_, faces_[i], 0, soup_.points.size(), fmt::format("{}: face {}", name_, i));
    return std::move(soup_);
  }

 private:
  void readHeader() {
    expectWord("ply");
    expectWord("format");
    readFormat(scanner_.word());
    expectWord("1.0");
    for (;;) {
      const std::string_view keyword = scanner_.word();
      if (keyword == "end_header") break;
      if (keyword == "comment" || keyword == "obj_info")
        scanner_.line();
      else if (keyword == "element")
        readElement();
      else if (keyword == "property")
        readProperty();
      else
        failAt(keyword, "element, property or end_header");
    }
    scanner_.line();
  }

  void readFormat(std::string_view format) {
    isBinary_ = format != "ascii";
    const bool isBigEndian = format == "binary_big_endian";
    if (isBinary_ && !isBigEndian && format != "binary_little_endian")
      failAt(format, "ascii, binary_little_endian or binary_big_endian");
    swapBytes_ = isBigEndian != kHostIsBigEndian;
  }

  void readElement() {
    Element element;
    element.name = scanner_.word();
    const std::string_view count = scanner_.word();
    if (!parseNumber(count, element.count)) failAt(count, "a whole number");
    elements_.push_back(std::move(element));
  }

  void readProperty() {
    if (elements_.empty()) failAt("property", "an element before it");
    Property property;
    if (scanner_.peekWord() == "list") {
      scanner_.word();
      property.countType = readType();
    }
    property.type = readType();
    property.name = scanner_.word();
    elements_.back().properties.push_back(std::move(property));
  }

  ArrayValues readType() {
    const std::string_view word = scanner_.word();
    auto type = typeNamed(word);
    if (!type) failAt(word, "char to uint, int8 to uint32, float or double");
    return std::move(*type);
  }

  void readPoints(const Element& element) {
    size_t axes[3] = {};
    for (int axis = 0; axis < 3; axis++) {
      const auto& p = element.properties;
      const auto found = std::find_if(p.begin(), p.end(), [&](const Property& q) {
        return q.name.size() == 1 && q.name[0] == "xyz"[axis] && !q.countType;
      });
      if (found == p.end())
        fail(ErrorCode::Input, "{}: no property '{}' of vertices, expected one", name_, "xyz"[axis]);
      axes[axis] = static_cast<size_t>(found - p.begin());
    }
    checkPointCount(soup_.points.size() + std::uint64_t{element.count}, name_);
    std::vector<double> row(element.properties.size());
    for (size_t i = 0; i < element.count; i++) {
      place_ = Place{"vertex", i};
      for (size_t k = 0; k < row.size(); k++) {
        const Property& property = element.properties[k];
        if (property.countType)
          readList(property);
        else
          row[k] = readNumber(property.type);
      }
      soup_.points.emplace_back(row[axes[0]], row[axes[1]], row[axes[2]]);
    }
  }

  void readFaces(const Element& element) {
    const auto isCorners = [](const Property& p) {
      return p.countType && (p.name == "vertex_indices" || p.name == "vertex_index");
    };
    if (std::none_of(element.properties.begin(), element.properties.end(), isCorners))
      fail(ErrorCode::Input, "{}: no list 'vertex_indices' of faces, expected one", name_);
    for (size_t i = 0; i < element.count; i++) {
      place_ = Place{"face", i};
      for (const Property& property : element.properties) {
        if (!property.countType) {
          readNumber(property.type);
          continue;
        }
        std::vector<double> list = readList(property);
        if (!isCorners(property)) continue;
        std::vector<std::int64_t>& face = faces_.emplace_back();
        for (const double number : list) face.push_back(wholeNumber(number));
      }
    }
  }

  void passOver(const Element& element) {
    spdlog::warn("{}: elements '{}' are left out", oneLine(name_), oneLine(element.name));
    if (element.properties.empty()) return;
    for (size_t i = 0; i < element.count; i++) {
      place_ = Place{"element", i};
      for (const Property& property : element.properties) {
        if (property.countType)
          readList(property);
        else
          readNumber(property.type);
      }
    }
  }

  std::vector<double> readList(const Property& property) {
    const std::int64_t count = wholeNumber(readNumber(*property.countType));
    if (count < 0) fail(ErrorCode::Input, "{}: a list of {} numbers, expected a number >= 0", where(), count);
    std::vector<double> list;
    for (std::int64_t i = 0; i < count; i++) list.push_back(readNumber(property.type));
    return list;
  }

  std::int64_t wholeNumber(double number) const {
    constexpr double kLargest = 0x1p53;
    if (!(std::abs(number) <= kLargest) || number != std::floor(number))
      fail(ErrorCode::Input, "{}: {}, expected a whole number", where(), number);
    return static_cast<std::int64_t>(number);
  }

  double readNumber(const ArrayValues& type) {
    return std::visit(
        [&](const auto& values) { return this->readAs<typename std::decay_t<decltype(values)>::value_type>(); }, type);
  }

  template <typename T>
  double readAs() {
    T value{};
    if (isBinary_) {
      if (scanner_.remaining() < sizeof value) fail(ErrorCode::Input, "{}: the file ends, expected a number", where());
      std::memcpy(&value, scanner_.bytes(sizeof value).data(), sizeof value);
      if (swapBytes_) swapBytes(&value, 1, sizeof value);
      return static_cast<double>(value);
    }
    const std::string_view word = scanner_.word();
    if (word.empty()) fail(ErrorCode::Input, "{}: the file ends, expected a number", where());
    if (!parseNumber(word, value)) fail(ErrorCode::Input, "{}: '{}', expected a number", where(), excerpt(word));
    return static_cast<double>(value);
  }

  void expectWord(const char* expected) {
    const std::string_view found = scanner_.word();
    if (found != expected) failAt(found, fmt::format("'{}'", expected));
  }

  // In the header.
  [[noreturn]] void failAt(std::string_view found, const std::string& expected) const {
    if (found.empty()) fail(ErrorCode::Input, "{}: the header ends, expected {}", name_, expected);
    fail(ErrorCode::Input, "{}: line {}: '{}', expected {}", name_, scanner_.lineNumber(), excerpt(found), expected);
  }

  std::string where() const { return fmt::format("{}: {} {}", name_, place_.element, place_.index); }

  struct Place {
    const char* element = "";
    size_t index = 0;
  };

  std::string name_;
  std::string file_;
  TextScanner scanner_;
  bool isBinary_ = false;
  bool swapBytes_ = false;
  std::vector<Element> elements_;
  Place place_;  // what is being read
  TriangleSoup soup_;
  std::vector<std::vector<std::int64_t>> faces_;  // points may come after them
};

}  // namespace

TriangleSoup readPly(const std::filesystem::path& path) { return PlyReader(path).read(); }

}  // namespace tetralux
