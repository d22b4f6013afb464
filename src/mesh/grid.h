// Meshes of cubes cut into tetrahedra.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

#include "mesh/field_function.h"
#include "mesh/tet_mesh.h"

namespace tetralux {

// nx x ny x nz boxes between `low` and `high`, six tetrahedra each (Kuhn 1960), all positive; neighbours match. Points
// are doubles, x fastest; cells go box by box in the same order; point array `fieldName` with field(position), which
// is also the preferred field. Time and memory linear in the cells (16 bytes each).
// Throws CheckFailure when there are more than 2^32 - 1 points.
//   nx, ny, nz   >= 1
//   low, high    world units, low < high along each axis
TetMesh kuhnGrid(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz, const glm::dvec3& low, const glm::dvec3& high,
                 const FieldFunction& field, const std::string& fieldName = "scalar");

// The same with every inner vertex moved along each axis by a random part of its box's edge, at most `jitter`; the
// border stays. All cells stay positive for jitter < 1/6.
//   jitter   >= 0, in edges
//   seed     the same seed gives the same mesh on every machine
TetMesh jitteredGrid(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz, const glm::dvec3& low,
                     const glm::dvec3& high, double jitter, std::uint32_t seed, const FieldFunction& field,
                     const std::string& fieldName = "scalar");

// n x n x n boxes in the unit cube whose edges grow geometrically along each axis, away from the origin, six
// tetrahedra each: large and small cells, and needles and plates of that ratio, in one valid mesh.
//   n       boxes along an edge, >= 2
//   ratio   longest edge along an axis through the shortest, >= 1; 1e5 still leaves 11 decimal digits to the
//           shortest edge's coordinates
TetMesh gradedBox(std::uint32_t n, double ratio, const FieldFunction& field = waveField,
                  const std::string& fieldName = "scalar");

}  // namespace tetralux
