// Neighbouring cells whose circumspheres are one sphere but for rounding.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "mesh/adjacency.h"
#include "mesh/tet_mesh.h"

namespace tetralux {

// Circumcentres closer than this share of the smaller radius count as one: a regular grid has that much of rounding in
// single precision as long as its cells are larger than 2^-8 of its coordinates. Of the faces of a Delaunay mesh of
// random points, some in 100,000 lie between such cells.
inline constexpr double kCosphericalTolerance = 0x1p-16;

// For every cell the cell whose circumsphere it shares: the one of lowest index among those reached across faces
// between cospherical cells; itself where there is none. A flat cell has no sphere and shares that of a neighbour that
// is not flat.
//   centers   circumcenters(mesh)
std::vector<std::uint32_t> cosphericalCells(const TetMesh& mesh, const Adjacency& adjacency,
                                            const std::vector<glm::dvec3>& centers);

}  // namespace tetralux
