// VTK legacy files (.vtk) with an unstructured grid.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.h"
#include "mesh/mesh_io.h"
#include "mesh/vtk_assemble.h"
#include "mesh/vtk_legacy_file.h"

namespace tetralux {
namespace {

// Arrays that are written as KEYWORD name type, by their number of components.
struct AttributeKind {
  const char* keyword;
  std::uint32_t components;
};
constexpr AttributeKind kAttributes[] = {
    {"vectors", 3},    {"normals", 3},      {"tensors", 9},    {"tensors6", 6},
    {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1},
};

// Reads section after section, then puts the mesh together: cells come before their types.
class LegacyReader {
 public:
  explicit LegacyReader(const std::filesystem::path& path) : file_(path) {}
  TetMesh read();

 private:
  // What the arrays that follow belong to.
  struct Attributes {
    std::vector<DataArray>* arrays = nullptr;  // none before POINT_DATA and CELL_DATA
    const char* what = "field";
    size_t tuples = 0;
    std::string scalars;  // name of the first that is declared as such
  };

  void readDataSetKind();
  bool readSection(const std::string& keyword);
  void readPoints();
  void readCells();
  void readCellTypes();
  bool readAttribute(const std::string& keyword);
  void readScalars();
  void readColorScalars();
  void readField();
  bool readArray(const std::string& name, const std::string& type, size_t components);
  std::optional<ArrayValues> arrayValues(const std::string& name, const std::string& type, size_t tuples,
                                         size_t components);
  void passOverLookupTable();
  void beginAttributes(Attributes& attributes, size_t tuples);
  void assembleCells();
  void splitCountedCells();
  ArrayValues numbers(const std::string& type, size_t count, const std::string& place);
  std::string place(const char* section) const { return fmt::format("{}: {}", file_.name(), section); }
  std::string arrayPlace(const std::string& name) const {
    return fmt::format("{}: {} array '{}'", file_.name(), current_->what, name);
  }

  VtkLegacyFile file_;
  TetMesh mesh_;
  size_t cellCount_ = 0;
  bool hasOffsets_ = false;  // version 5: offsets_ and vertices_; before: vertices_ with each cell's count
  ArrayValues offsets_;
  ArrayValues vertices_ = std::vector<std::int32_t>();
  ArrayValues types_ = std::vector<std::int32_t>();
  Attributes outside_;
  Attributes point_{&mesh_.pointArrays, "point", 0, {}};
  Attributes cell_{&mesh_.cellArrays, "cell", 0, {}};
  Attributes* current_ = &outside_;
};

TetMesh LegacyReader::read() {
  readDataSetKind();
  for (std::string keyword = file_.keyword(); !keyword.empty(); keyword = file_.keyword()) {
    if (!readSection(keyword) && !readAttribute(keyword))
      fail(ErrorCode::Input,
           "{}: {}: keyword '{}', expected POINTS, CELLS, CELL_TYPES, POINT_DATA, CELL_DATA or an array's",
           file_.name(), file_.location(), excerpt(keyword));
  }
  assembleCells();
  mesh_.preferredField = point_.scalars.empty() ? cell_.scalars : point_.scalars;
  validate(mesh_, file_.name());
  return std::move(mesh_);
}

void LegacyReader::readDataSetKind() {
  const std::string keyword = file_.keyword();
  if (keyword != "dataset")
    fail(ErrorCode::Input, "{}: {}: '{}', expected DATASET", file_.name(), file_.location(), excerpt(keyword));
  const std::string kind = file_.keyword();
  if (kind != "unstructured_grid")
    fail(ErrorCode::Input, "{}: {}: DATASET is '{}', expected UNSTRUCTURED_GRID", file_.name(), file_.location(),
         excerpt(kind));
}

bool LegacyReader::readSection(const std::string& keyword) {
  if (keyword == "points") {
    readPoints();
  } else if (keyword == "cells") {
    readCells();
  } else if (keyword == "cell_types") {
    readCellTypes();
  } else if (keyword == "point_data") {
    beginAttributes(point_, mesh_.pointCount());
  } else if (keyword == "cell_data") {
    beginAttributes(cell_, cellCount_);
  } else {
    return false;
  }
  return true;
}

// An array that must hold numbers.
ArrayValues LegacyReader::numbers(const std::string& type, size_t count, const std::string& place) {
  auto values = file_.values(type, count, 1, place);
  if (!values) fail(ErrorCode::Input, "{}: type '{}', expected a number type", place, excerpt(type));
  return std::move(*values);
}

void LegacyReader::readPoints() {
  const size_t points = file_.count("the number of points");
  checkPointCount(points, place("POINTS"));
  const std::string type = file_.text("a number type");
  mesh_.points = {};
  appendPoints(mesh_, numbers(type, 3 * points, place("POINTS")));
}

void LegacyReader::readCells() {
  const size_t first = file_.count("the number of cells");
  const size_t size = file_.count("the size of the cell list");
  // Version 5 has two arrays here. A file is believed rather than its version number: some writers mix them up.
  hasOffsets_ = file_.peekKeyword() == "offsets";
  if (!hasOffsets_) {
    cellCount_ = first;
    vertices_ = numbers("int", size, place("CELLS"));
    return;
  }
  cellCount_ = first == 0 ? 0 : first - 1;
  file_.keyword();
  offsets_ = numbers(file_.text("a number type"), first, place("OFFSETS"));
  const std::string keyword = file_.keyword();
  if (keyword != "connectivity")
    fail(ErrorCode::Input, "{}: {}: '{}', expected CONNECTIVITY", file_.name(), file_.location(), excerpt(keyword));
  vertices_ = numbers(file_.text("a number type"), size, place("CONNECTIVITY"));
}

void LegacyReader::readCellTypes() {
  const size_t count = file_.count("the number of cells");
  if (count != cellCount_)
    fail(ErrorCode::Input, "{}: {} types, expected the number of cells, {}", place("CELL_TYPES"), count, cellCount_);
  types_ = numbers("int", count, place("CELL_TYPES"));
}

void LegacyReader::beginAttributes(Attributes& attributes, size_t tuples) {
  const size_t count = file_.count("the number of tuples");
  if (count != tuples)
    fail(ErrorCode::Input, "{}: {} tuples, expected the number of {}s, {}",
         place(&attributes == &point_ ? "POINT_DATA" : "CELL_DATA"), count, attributes.what, tuples);
  attributes.tuples = tuples;
  current_ = &attributes;
}

bool LegacyReader::readAttribute(const std::string& keyword) {
  if (keyword == "field") {
    readField();
    return true;
  }
  if (!current_->arrays) return false;
  if (keyword == "scalars") {
    readScalars();
    return true;
  }
  if (keyword == "color_scalars") {
    readColorScalars();
    return true;
  }
  if (keyword == "lookup_table") {
    passOverLookupTable();
    return true;
  }
  if (keyword == "texture_coordinates") {
    const std::string name = file_.text("a name");
    const size_t components = file_.count("the number of components");
    readArray(name, file_.text("a number type"), components);
    return true;
  }
  for (const AttributeKind& kind : kAttributes) {
    if (keyword != kind.keyword) continue;
    const std::string name = file_.text("a name");
    readArray(name, file_.text("a number type"), kind.components);
    return true;
  }
  return false;
}

// SCALARS name type [components], LOOKUP_TABLE name
void LegacyReader::readScalars() {
  const std::string name = file_.text("a name");
  const std::string type = file_.text("a number type");
  const size_t components = file_.peekKeyword() == "lookup_table" ? 1 : file_.count("LOOKUP_TABLE");
  const std::string keyword = file_.keyword();
  if (keyword != "lookup_table")
    fail(ErrorCode::Input, "{}: {}: '{}', expected LOOKUP_TABLE", file_.name(), file_.location(), excerpt(keyword));
  file_.text("the lookup table's name");
  if (readArray(name, type, components) && current_->scalars.empty()) current_->scalars = name;
}

// Bytes in binary files, numbers from 0 to 1 in text.
void LegacyReader::readColorScalars() {
  const std::string name = file_.text("a name");
  const size_t components = file_.count("the number of components");
  if (current_->scalars.empty()) current_->scalars = name;
  if (file_.isBinary()) {
    readArray(name, "unsigned_char", components);
    return;
  }
  auto values = arrayValues(name, "float", current_->tuples, components);
  const auto& shares = std::get<std::vector<float>>(*values);
  std::vector<std::uint8_t> bytes(shares.size());
  std::transform(shares.begin(), shares.end(), bytes.begin(), [](float share) {
    return share > 0.0f ? static_cast<std::uint8_t>(std::lround(255.0f * std::min(share, 1.0f))) : std::uint8_t{0};
  });
  addArray(*current_->arrays, {name, static_cast<std::uint32_t>(components), std::move(bytes)}, arrayPlace(name));
}

// FIELD name count, then for each array: name components tuples type
void LegacyReader::readField() {
  file_.text("a name");
  const size_t count = file_.count("the number of arrays");
  for (size_t i = 0; i < count; i++) {
    const std::string name = file_.text("an array's name");
    if (name == "NULL_ARRAY") continue;
    const size_t components = file_.count("the number of components");
    const size_t tuples = file_.count("the number of tuples");
    const std::string type = file_.text("a number type");
    auto values = arrayValues(name, type, tuples, components);
    if (!values || !current_->arrays) continue;
    addArray(*current_->arrays, {name, static_cast<std::uint32_t>(components), std::move(*values)}, arrayPlace(name));
  }
}

std::optional<ArrayValues> LegacyReader::arrayValues(const std::string& name, const std::string& type, size_t tuples,
                                                     size_t components) {
  if (components == 0 || components > std::numeric_limits<std::uint32_t>::max())
    fail(ErrorCode::Input, "{}: {} components, expected at least 1", arrayPlace(name), components);
  if (current_->arrays && tuples != current_->tuples)
    fail(ErrorCode::Input, "{}: {} tuples, expected {}", arrayPlace(name), tuples, current_->tuples);
  return file_.values(type, tuples, components, arrayPlace(name));
}

// False for an array that was passed over.
bool LegacyReader::readArray(const std::string& name, const std::string& type, size_t components) {
  auto values = arrayValues(name, type, current_->tuples, components);
  if (!values) return false;
  addArray(*current_->arrays, {name, static_cast<std::uint32_t>(components), std::move(*values)}, arrayPlace(name));
  return true;
}

void LegacyReader::passOverLookupTable() {
  file_.text("the lookup table's name");
  const size_t size = file_.count("the size of the lookup table");
  file_.values(file_.isBinary() ? "unsigned_char" : "float", size, 4, place("LOOKUP_TABLE"));
}

// Before version 5 every cell's vertices follow their number.
void LegacyReader::splitCountedCells() {
  auto& list = std::get<std::vector<std::int32_t>>(vertices_);
  size_t position = 0;
  for (size_t i = 0; i < cellCount_; i++, position += 5) {
    if (position >= list.size())
      fail(ErrorCode::Input, "{}: {} numbers hold {} cells, expected {}", place("CELLS"), list.size(), i, cellCount_);
    if (list[position] != 4)
      fail(ErrorCode::Input, "{}: cell {}: {} vertices, expected 4", file_.name(), i, list[position]);
    if (list.size() - position < 5)
      fail(ErrorCode::Input, "{}: cell {}: {} vertices are left in the list, expected 4", file_.name(), i,
           list.size() - position - 1);
    std::copy_n(list.begin() + static_cast<std::ptrdiff_t>(position + 1), 4,
                list.begin() + static_cast<std::ptrdiff_t>(4 * i));
  }
  if (position != list.size())
    fail(ErrorCode::Input, "{}: {} numbers, expected {} for {} cells", place("CELLS"), list.size(), position,
         cellCount_);
  list.resize(4 * cellCount_);
}

void LegacyReader::assembleCells() {
  if (cellCount_ == 0) fail(ErrorCode::Input, "{}: no cells, expected at least 1 tetrahedron", file_.name());
  const size_t typeCount = std::visit([](const auto& v) { return v.size(); }, types_);
  if (typeCount != cellCount_)
    fail(ErrorCode::Input, "{}: {} types, expected the number of cells, {}", place("CELL_TYPES"), typeCount,
         cellCount_);
  checkCellTypes(types_, file_.name());
  if (hasOffsets_) {
    std::visit(
        [&](auto& v) {
          if (v.front() != 0) fail(ErrorCode::Input, "{}: the first is {}, expected 0", place("OFFSETS"), v.front());
          v.erase(v.begin());
        },
        offsets_);
    checkCellEnds(offsets_, file_.name());
    const size_t size = std::visit([](const auto& v) { return v.size(); }, vertices_);
    if (size != 4 * cellCount_)
      fail(ErrorCode::Input, "{}: {} vertices, expected {}", place("CONNECTIVITY"), size, 4 * cellCount_);
  } else {
    splitCountedCells();
  }
  appendCells(mesh_, vertices_, 0, mesh_.pointCount(), file_.name());
  vertices_ = {};
}

}  // namespace

TetMesh readLegacyVtk(const std::filesystem::path& path) { return LegacyReader(path).read(); }

}  // namespace tetralux
