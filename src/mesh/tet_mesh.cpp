#include "mesh/tet_mesh.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "base/error.h"

namespace tetralux {
namespace {

const DataArray* findArray(const std::vector<DataArray>& arrays, std::string_view name) {
  const auto found = std::find_if(arrays.begin(), arrays.end(), [&](const DataArray& a) { return a.name == name; });
  return found == arrays.end() ? nullptr : &*found;
}

// The array drawn when none is named: a scalar is a better guess than the length of a vector, points a better one
// than cells.
std::string defaultFieldName(const TetMesh& mesh) {
  if (!mesh.preferredField.empty()) return mesh.preferredField;
  for (const bool anyComponents : {false, true}) {
    for (const auto* arrays : {&mesh.pointArrays, &mesh.cellArrays}) {
      for (const DataArray& array : *arrays) {
        if (anyComponents || array.components == 1) return array.name;
      }
    }
  }
  return {};
}

std::string listArrays(const TetMesh& mesh) {
  std::vector<std::string> names;
  for (const DataArray& a : mesh.pointArrays) names.push_back(fmt::format("'{}'", a.name));
  for (const DataArray& a : mesh.cellArrays) names.push_back(fmt::format("'{}' (cells)", a.name));
  return names.empty() ? "no array at all" : fmt::format("{}", fmt::join(names, ", "));
}

double tupleMagnitude(const DataArray& array, size_t tuple) {
  if (array.components == 1) return array.value(tuple);
  double sum = 0.0;
  for (std::uint32_t c = 0; c < array.components; c++) sum = std::hypot(sum, array.value(tuple, c));
  return sum;
}

}  // namespace

double Bounds::diagonal() const {
  const glm::dvec3 extent = high - low;
  return std::hypot(extent.x, extent.y, extent.z);
}

size_t TetMesh::pointCount() const {
  return std::visit([](const auto& p) { return p.size(); }, points);
}

glm::dvec3 TetMesh::point(size_t index) const {
  return std::visit([index](const auto& p) { return glm::dvec3(p[index]); }, points);
}

Bounds TetMesh::bounds() const {
  if (pointCount() == 0) return {};
  return std::visit(
      [](const auto& p) {
        auto low = p[0];
        auto high = p[0];
        for (const auto& q : p) {
          low = glm::min(low, q);
          high = glm::max(high, q);
        }
        return Bounds{glm::dvec3(low), glm::dvec3(high)};
      },
      points);
}

size_t TetMesh::sizeBytes() const {
  size_t bytes = std::visit([](const auto& p) { return p.size() * sizeof p[0]; }, points);
  bytes += cells.size() * sizeof cells[0];
  for (const auto* arrays : {&pointArrays, &cellArrays}) {
    for (const DataArray& a : *arrays) bytes += a.sizeBytes();
  }
  return bytes;
}

void validate(const TetMesh& mesh, std::string_view place) {
  const size_t points = mesh.pointCount();
  std::visit(
      [&](const auto& p) {
        for (size_t i = 0; i < p.size(); i++) {
          for (int axis = 0; axis < 3; axis++) {
            if (!std::isfinite(p[i][axis]))
              fail(ErrorCode::Input, "{}: point {}: coordinate {} is {}, expected a finite number", place, i,
                   "xyz"[axis], p[i][axis]);
          }
        }
      },
      mesh.points);
  for (size_t i = 0; i < mesh.cells.size(); i++) {
    for (const std::uint32_t vertex : mesh.cells[i]) {
      if (vertex >= points)
        fail(ErrorCode::Input, "{}: cell {}: vertex index {}, expected below the number of points, {}", place, i,
             vertex, points);
    }
  }
  const auto checkArrays = [&](const std::vector<DataArray>& arrays, size_t expected, const char* what) {
    for (const DataArray& a : arrays) {
      if (a.components == 0 || a.size() != expected * a.components)
        fail(ErrorCode::Input, "{}: {} array '{}' has {} values of {} components, expected {} tuples", place, what,
             a.name, a.size(), a.components, expected);
    }
  };
  checkArrays(mesh.pointArrays, points, "point");
  checkArrays(mesh.cellArrays, mesh.cells.size(), "cell");
}

ScalarField scalarField(const TetMesh& mesh, std::string_view name, std::string_view place) {
  ScalarField field;
  field.name = name.empty() ? defaultFieldName(mesh) : std::string(name);
  if (field.name.empty()) fail(ErrorCode::Input, "{}: has no point or cell array to draw", place);
  const DataArray* array = findArray(mesh.pointArrays, field.name);
  if (!array) {
    array = findArray(mesh.cellArrays, field.name);
    field.association = FieldAssociation::Cell;
  }
  if (!array) fail(ErrorCode::Input, "{}: no array '{}', the mesh has {}", place, field.name, listArrays(mesh));
  field.values.resize(array->tuples());
  field.low = std::numeric_limits<double>::infinity();
  field.high = -std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < field.values.size(); i++) {
    const double value = tupleMagnitude(*array, i);
    if (!std::isfinite(value))
      fail(ErrorCode::Input, "{}: array '{}': {} {}: value is {}, expected a finite number", place, field.name,
           field.association == FieldAssociation::Point ? "point" : "cell", i, value);
    field.values[i] = value;
    field.low = std::min(field.low, value);
    field.high = std::max(field.high, value);
  }
  if (field.values.empty()) field.low = field.high = 0.0;
  return field;
}

}  // namespace tetralux
