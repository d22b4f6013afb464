// The mesh: points, tetrahedra, and named arrays, as stored in the file.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mesh/data_array.h"

namespace tetralux {

using CellVertices = std::array<std::uint32_t, 4>;

// Axis-aligned box, world units.
struct Bounds {
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};

  glm::dvec3 center() const { return 0.5 * low + 0.5 * high; }
  // Length of the diagonal, >= 0.
  double diagonal() const;
};

// Invariants (validate() checks them; readers and generators guarantee them): every coordinate is finite; every
// vertex index is below pointCount(); every point array has pointCount() tuples, every cell array cellCount().
// Cells may be inverted, flat, duplicate or overlapping: a cell is the set of points between its vertices.
struct TetMesh {
  std::variant<std::vector<glm::vec3>, std::vector<glm::dvec3>> points;  // world units
  std::vector<CellVertices> cells;
  std::vector<DataArray> pointArrays;
  std::vector<DataArray> cellArrays;
  std::string preferredField;  // the file's active scalar, or empty

  size_t pointCount() const;
  size_t cellCount() const { return cells.size(); }
  bool hasDoublePoints() const { return points.index() == 1; }
  glm::dvec3 point(size_t index) const;

  // Box of all points; zero for a mesh without points.
  Bounds bounds() const;

  // Bytes of all arrays.
  size_t sizeBytes() const;
};

// Throws Error(Input) that begins with `place` and names the first broken invariant, with its index.
void validate(const TetMesh& mesh, std::string_view place);

// Where a field's numbers live.
enum class FieldAssociation { Point, Cell };

// The scalar that is drawn: one finite double per point or per cell.
struct ScalarField {
  std::string name;
  FieldAssociation association = FieldAssociation::Point;
  std::vector<double> values;
  double low = 0.0;   // smallest value
  double high = 0.0;  // largest value
};

// Picks an array by name: a point array first, then a cell array. A vector gives its length (Euclidean norm).
// Throws Error(Input) when no such array exists (the message lists those that do) or a value is not finite.
//   name    empty: the file's active scalar, else its first one-component array, else its first array
//   place   begins the error message, usually the file's name
ScalarField scalarField(const TetMesh& mesh, std::string_view name, std::string_view place);

}  // namespace tetralux
