// VTK XML unstructured grids (.vtu).
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "mesh/mesh_io.h"
#include "mesh/vtk_assemble.h"
#include "mesh/vtk_text.h"
#include "mesh/vtk_types.h"
#include "mesh/vtk_xml_file.h"

namespace tetralux {
namespace {

// A part of the grid, with points of its own.
struct Piece {
  pugi::xml_node element;
  size_t points = 0;
  size_t cells = 0;
  std::string place;
};

std::vector<Piece> findPieces(const VtkXmlFile& file) {
  std::vector<Piece> pieces;
  for (const pugi::xml_node element : file.dataSet().children("Piece")) {
    pieces.push_back({element, 0, 0, fmt::format("{}: piece {}", file.name(), pieces.size())});
  }
  if (pieces.empty()) fail(ErrorCode::Input, "{}: no Piece in UnstructuredGrid, expected at least one", file.name());
  if (pieces.size() == 1) pieces[0].place = file.name();
  std::uint64_t points = 0;
  for (Piece& piece : pieces) {
    piece.points = countAttribute(piece.element, "NumberOfPoints", piece.place);
    piece.cells = countAttribute(piece.element, "NumberOfCells", piece.place);
    checkPointCount(piece.points, piece.place);
    checkPointCount(points += piece.points, file.name());
  }
  // Parallel writers leave parts empty, and leave arrays out of those.
  std::erase_if(pieces, [](const Piece& piece) { return piece.points == 0 && piece.cells == 0; });
  return pieces;
}

size_t totalNumbers(size_t tuples, size_t components, std::string_view place) {
  const auto count = numberCount(tuples, components);
  if (!count || components > std::numeric_limits<std::uint32_t>::max())
    fail(ErrorCode::Input, "{}: {} tuples of {} components, expected fewer", place, tuples, components);
  return *count;
}

// An array that every piece must have.
ArrayValues requiredValues(const VtkXmlFile& file, const Piece& piece, const char* name, size_t perCell) {
  const pugi::xml_node cells = piece.element.child("Cells");
  const pugi::xml_node array = cells.find_child_by_attribute("DataArray", "Name", name);
  if (!array) fail(ErrorCode::Input, "{}: no array '{}' in Cells, expected one", piece.place, name);
  const std::string place = fmt::format("{}: {}", piece.place, name);
  return file.values(array, totalNumbers(piece.cells, perCell, place), place);
}

void readPoints(const VtkXmlFile& file, const Piece& piece, TetMesh& mesh) {
  const std::string place = piece.place + ": Points";
  const pugi::xml_node array = piece.element.child("Points").child("DataArray");
  if (!array) fail(ErrorCode::Input, "{}: no DataArray, expected one", place);
  if (array.attribute("NumberOfComponents") && countAttribute(array, "NumberOfComponents", place) != 3)
    fail(ErrorCode::Input, "{}: NumberOfComponents is {}, expected 3", place,
         excerpt(array.attribute("NumberOfComponents").value()));
  appendPoints(mesh, file.values(array, totalNumbers(piece.points, 3, place), place));
}

void readCells(const VtkXmlFile& file, const Piece& piece, size_t firstPoint, TetMesh& mesh) {
  if (piece.cells == 0) return;
  // One array at a time: for large meshes each is a good part of what is in memory.
  checkCellTypes(requiredValues(file, piece, "types", 1), piece.place);
  checkCellEnds(requiredValues(file, piece, "offsets", 1), piece.place);
  appendCells(mesh, requiredValues(file, piece, "connectivity", 4), firstPoint, piece.points, piece.place);
}

// Arrays of numbers in PointData or CellData.
std::vector<DataArray> readArrays(const VtkXmlFile& file, const Piece& piece, const char* group, const char* what,
                                  size_t tuples) {
  std::vector<DataArray> arrays;
  size_t index = 0;
  for (const pugi::xml_node element : piece.element.child(group).children()) {
    if (element.type() != pugi::node_element) continue;
    DataArray array;
    const pugi::xml_attribute name = element.attribute("Name");
    array.name = name ? name.value() : fmt::format("Array {}", index);
    index++;
    const std::string place = fmt::format("{}: {} array '{}'", piece.place, what, array.name);
    const std::string_view type = element.attribute("type").value();
    if (std::strcmp(element.name(), "DataArray") != 0 || type == "String" || type == "Bit") {
      spdlog::warn("{}: not read: {} of type '{}'", oneLine(place), element.name(), excerpt(type));
      continue;
    }
    std::uint64_t components = 1;
    if (element.attribute("NumberOfComponents")) components = countAttribute(element, "NumberOfComponents", place);
    if (components == 0) fail(ErrorCode::Input, "{}: NumberOfComponents is 0, expected at least 1", place);
    const size_t count = totalNumbers(tuples, components, place);
    array.components = static_cast<std::uint32_t>(components);
    array.values = file.values(element, count, place);
    addArray(arrays, std::move(array), place);
  }
  return arrays;
}

// Appends a later piece's arrays to those of the pieces before it.
void joinArrays(std::vector<DataArray>& arrays, std::vector<DataArray>&& more, const Piece& piece, const char* what) {
  for (const DataArray& array : more) {
    if (std::none_of(arrays.begin(), arrays.end(), [&](const DataArray& a) { return a.name == array.name; }))
      fail(ErrorCode::Input, "{}: {} array '{}', expected the arrays of the first piece only", piece.place, what,
           array.name);
  }
  for (DataArray& array : arrays) {
    const auto part = std::find_if(more.begin(), more.end(), [&](const DataArray& a) { return a.name == array.name; });
    if (part == more.end())
      fail(ErrorCode::Input, "{}: no {} array '{}', expected the arrays of the first piece", piece.place, what,
           array.name);
    if (part->components != array.components || part->values.index() != array.values.index())
      fail(ErrorCode::Input, "{}: {} array '{}' has {} components of type {}, expected {} of type {}", piece.place,
           what, array.name, part->components, part->typeName(), array.components, array.typeName());
    std::visit(
        [&](auto& values) {
          const auto& tail = std::get<std::decay_t<decltype(values)>>(part->values);
          values.insert(values.end(), tail.begin(), tail.end());
        },
        array.values);
  }
}

bool hasArray(const std::vector<DataArray>& arrays, std::string_view name) {
  return std::any_of(arrays.begin(), arrays.end(), [&](const DataArray& a) { return a.name == name; });
}

// The file's active scalars, where that array was read.
std::string activeScalars(const Piece& piece, const TetMesh& mesh) {
  const char* atPoints = piece.element.child("PointData").attribute("Scalars").value();
  if (hasArray(mesh.pointArrays, atPoints)) return atPoints;
  const char* inCells = piece.element.child("CellData").attribute("Scalars").value();
  if (hasArray(mesh.cellArrays, inCells)) return inCells;
  return {};
}

}  // namespace

TetMesh readVtu(const std::filesystem::path& path) {
  const VtkXmlFile file(path, "UnstructuredGrid");
  const std::vector<Piece> pieces = findPieces(file);
  TetMesh mesh;
  for (size_t i = 0; i < pieces.size(); i++) {
    const Piece& piece = pieces[i];
    const size_t firstPoint = mesh.pointCount();
    readPoints(file, piece, mesh);
    readCells(file, piece, firstPoint, mesh);
    auto pointArrays = readArrays(file, piece, "PointData", "point", piece.points);
    auto cellArrays = readArrays(file, piece, "CellData", "cell", piece.cells);
    if (i == 0) {
      mesh.pointArrays = std::move(pointArrays);
      mesh.cellArrays = std::move(cellArrays);
      mesh.preferredField = activeScalars(piece, mesh);
    } else {
      joinArrays(mesh.pointArrays, std::move(pointArrays), piece, "point");
      joinArrays(mesh.cellArrays, std::move(cellArrays), piece, "cell");
    }
  }
  if (mesh.cells.empty()) fail(ErrorCode::Input, "{}: no cells, expected at least 1 tetrahedron", file.name());
  validate(mesh, file.name());
  return mesh;
}

}  // namespace tetralux
