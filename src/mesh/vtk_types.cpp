#include "mesh/vtk_types.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include "mesh/vtk_text.h"

namespace tetralux {
namespace {

struct CellTypeName {
  int type;
  const char* name;
};

constexpr CellTypeName kCellTypeNames[] = {
    {0, "empty cell"},
    {1, "vertex"},
    {2, "poly-vertex"},
    {3, "line"},
    {4, "poly-line"},
    {5, "triangle"},
    {6, "triangle strip"},
    {7, "polygon"},
    {8, "pixel"},
    {9, "quad"},
    {10, "tetrahedron"},
    {11, "voxel"},
    {12, "hexahedron"},
    {13, "wedge"},
    {14, "pyramid"},
    {15, "pentagonal prism"},
    {16, "hexagonal prism"},
    {21, "quadratic edge"},
    {22, "quadratic triangle"},
    {23, "quadratic quad"},
    {24, "quadratic tetrahedron"},
    {25, "quadratic hexahedron"},
    {26, "quadratic wedge"},
    {27, "quadratic pyramid"},
    {28, "biquadratic quad"},
    {29, "triquadratic hexahedron"},
    {42, "polyhedron"},
    {68, "Lagrange curve"},
    {69, "Lagrange triangle"},
    {70, "Lagrange quadrilateral"},
    {71, "Lagrange tetrahedron"},
    {72, "Lagrange hexahedron"},
    {73, "Lagrange wedge"},
    {78, "Bezier tetrahedron"},
    {79, "Bezier hexahedron"},
};

template <typename T>
ArrayValues valuesOf() {
  return std::vector<T>();
}

struct NumberTypeName {
  std::string_view name;
  ArrayValues (*values)();
};

constexpr NumberTypeName kXmlTypes[] = {
    {"Int8", valuesOf<std::int8_t>},     {"UInt8", valuesOf<std::uint8_t>},     {"Int16", valuesOf<std::int16_t>},
    {"UInt16", valuesOf<std::uint16_t>}, {"Int32", valuesOf<std::int32_t>},     {"UInt32", valuesOf<std::uint32_t>},
    {"Int64", valuesOf<std::int64_t>},   {"UInt64", valuesOf<std::uint64_t>},   {"Float32", valuesOf<float>},
    {"Float64", valuesOf<double>},       {"vtkIdType", valuesOf<std::int64_t>},  // as some writers call what VTK itself
                                                                                 // writes as Int64
};

constexpr NumberTypeName kLegacyTypes[] = {
    {"char", valuesOf<std::int8_t>},
    {"signed_char", valuesOf<std::int8_t>},
    {"unsigned_char", valuesOf<std::uint8_t>},
    {"short", valuesOf<std::int16_t>},
    {"unsigned_short", valuesOf<std::uint16_t>},
    {"int", valuesOf<std::int32_t>},
    {"unsigned_int", valuesOf<std::uint32_t>},
    {"long", valuesOf<std::int64_t>},  // 64 bits, as on every 64-bit Unix
    {"unsigned_long", valuesOf<std::uint64_t>},
    {"vtktypeint64", valuesOf<std::int64_t>},
    {"vtktypeuint64", valuesOf<std::uint64_t>},
    {"vtkidtype", valuesOf<std::int32_t>},  // VTK writes its 64-bit ids as 32-bit numbers under this name
    {"float", valuesOf<float>},
    {"double", valuesOf<double>},
};

template <typename Table>
std::optional<ArrayValues> findType(const Table& table, std::string_view name) {
  for (const NumberTypeName& entry : table) {
    if (entry.name == name) return entry.values();
  }
  return std::nullopt;
}

template <typename T>
T reversed(T bits) {
  T result = 0;
  for (size_t i = 0; i < sizeof(T); i++) {
    result = static_cast<T>(result << 8 | (bits & 0xff));
    bits = static_cast<T>(bits >> 8);
  }
  return result;
}

template <typename T>
void swapAll(void* numbers, size_t count) {
  auto* bytes = static_cast<std::byte*>(numbers);
  for (size_t i = 0; i < count; i++, bytes += sizeof(T)) {
    T bits;
    std::memcpy(&bits, bytes, sizeof bits);
    bits = reversed(bits);
    std::memcpy(bytes, &bits, sizeof bits);
  }
}

}  // namespace

const char* cellTypeName(std::int64_t type) {
  for (const CellTypeName& entry : kCellTypeNames) {
    if (entry.type == type) return entry.name;
  }
  return "unknown";
}

std::optional<ArrayValues> valuesOfXmlType(std::string_view name) { return findType(kXmlTypes, name); }

std::optional<ArrayValues> valuesOfLegacyType(std::string_view name) { return findType(kLegacyTypes, lowerCase(name)); }

size_t numberSize(const ArrayValues& values) {
  return std::visit([](const auto& v) { return sizeof(typename std::decay_t<decltype(v)>::value_type); }, values);
}

void swapBytes(void* numbers, size_t count, size_t width) {
  if (width == 2) swapAll<std::uint16_t>(numbers, count);
  if (width == 4) swapAll<std::uint32_t>(numbers, count);
  if (width == 8) swapAll<std::uint64_t>(numbers, count);
}

std::optional<size_t> numberCount(size_t tuples, size_t components) {
  constexpr size_t kMost = std::numeric_limits<std::ptrdiff_t>::max() / sizeof(double);
  if (components != 0 && tuples > kMost / components) return std::nullopt;
  return tuples * components;
}

}  // namespace tetralux
