#include "unit/mesh/legacy_builder.h"

#include <fmt/format.h>

#include <algorithm>

#include "unit/mesh/vtu_builder.h"

namespace tetralux::test {
namespace {

const char* legacyTypeName(const ArrayValues& values) {
  constexpr const char* kNames[] = {"char",         "unsigned_char", "short",         "unsigned_short", "int",
                                    "unsigned_int", "vtktypeint64",  "vtktypeuint64", "float",          "double"};
  return kNames[values.index()];
}

// As VTK does it: whatever would end a word, and '%' itself.
std::string encoded(const std::string& name) {
  std::string result;
  for (const char c : name) result += c <= ' ' || c == '%' || c == '"' ? fmt::format("%{:02X}", c) : std::string(1, c);
  return result;
}

std::string group(const char* keyword, const std::vector<DataArray>& arrays, size_t tuples,
                  const std::string& preferred, const LegacyFormat& format) {
  if (arrays.empty()) return {};
  std::string text = fmt::format("{} {}\n", keyword, tuples);
  size_t others = arrays.size();
  for (const DataArray& a : arrays) {
    if (a.name != preferred) continue;
    text += fmt::format("SCALARS {} {}{}\nLOOKUP_TABLE default\n", encoded(a.name), legacyTypeName(a.values),
                        a.components == 1 ? "" : fmt::format(" {}", a.components));
    text += legacyNumbers(a.values, format);
    others--;
  }
  if (others > 0) text += fmt::format("FIELD FieldData {}\n", others);
  for (const DataArray& a : arrays) {
    if (a.name == preferred) continue;
    text += fmt::format("{} {} {} {}\n", encoded(a.name), a.components, tuples, legacyTypeName(a.values));
    text += legacyNumbers(a.values, format);
  }
  return text;
}

}  // namespace

std::string legacyNumbers(const ArrayValues& values, const LegacyFormat& format) {
  std::string text = (format.binary ? numberBytes(values, true) : numberText(values)) + "\n";
  if (format.metadata)
    text +=
        "METADATA\nCOMPONENT_NAMES\nx%20y\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1 \n\n";
  return text;
}

std::string legacyGrid(const TetMesh& mesh, const LegacyFormat& format) {
  std::string text = fmt::format("# vtk DataFile Version {}\na title\n{}\nDATASET UNSTRUCTURED_GRID\n",
                                 format.version5 ? "5.1" : "4.2", format.binary ? "BINARY" : "ASCII");
  std::vector<double> coordinates;
  for (size_t i = 0; i < mesh.pointCount(); i++) {
    for (int axis = 0; axis < 3; axis++) coordinates.push_back(mesh.point(i)[axis]);
  }
  const ArrayValues points = mesh.hasDoublePoints() ? coordinates : convertedTo(std::vector<float>(), coordinates);
  text += fmt::format("POINTS {} {}\n", mesh.pointCount(), legacyTypeName(points)) + legacyNumbers(points, format);
  std::vector<std::int32_t> counted, vertices, ends = {0};
  for (const CellVertices& cell : mesh.cells) {
    counted.push_back(4);
    counted.insert(counted.end(), cell.begin(), cell.end());
    vertices.insert(vertices.end(), cell.begin(), cell.end());
    ends.push_back(static_cast<std::int32_t>(vertices.size()));
  }
  if (format.version5) {
    text += fmt::format("CELLS {} {}\nOFFSETS {}\n", ends.size(), vertices.size(), legacyTypeName(format.indexType));
    text += legacyNumbers(convertedTo(format.indexType, ends), format);
    text += fmt::format("CONNECTIVITY {}\n", legacyTypeName(format.indexType));
    text += legacyNumbers(convertedTo(format.indexType, vertices), format);
  } else {
    text += fmt::format("CELLS {} {}\n", mesh.cellCount(), counted.size()) + legacyNumbers(counted, format);
  }
  text += fmt::format("CELL_TYPES {}\n", mesh.cellCount());
  return text + legacyNumbers(std::vector<std::int32_t>(mesh.cellCount(), 10), format);
}

std::string legacyArrays(const TetMesh& mesh, const LegacyFormat& format) {
  return group("POINT_DATA", mesh.pointArrays, mesh.pointCount(), mesh.preferredField, format) +
         group("CELL_DATA", mesh.cellArrays, mesh.cellCount(), mesh.preferredField, format);
}

std::string buildLegacy(const TetMesh& mesh, const LegacyFormat& format) {
  return legacyGrid(mesh, format) + legacyArrays(mesh, format);
}

}  // namespace tetralux::test
