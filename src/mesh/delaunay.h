// Delaunay meshes of point sets.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "mesh/tet_mesh.h"

namespace tetralux {

// Delaunay tetrahedra of a point set. They fill its convex hull; every volume is positive, exactly, and every face has
// one or two cells. Points are first rounded to a grid on which the predicates are exact; of points that then coincide
// only the first is kept. The grid's step is a power of two, 2^-20 to 2^-19 of the longest side of the points' box (far
// from the origin at least 4 units in the last place of a coordinate), and the grid holds the origin: coordinates that
// are multiples of the step stay as they are.
// Points are doubles in the order given. The mesh depends on the set of points alone, not on their order, chance or
// the machine: ties among cospherical points are broken by their coordinates, and cells are numbered by their vertices
// (smallest vertex first, sorted), so cells are near in memory where points are.
// Single-threaded; about 60 bytes per cell at work.
// Throws CheckFailure when fewer than four points are left, when all are coplanar, for a coordinate that is not
// finite, and for 2^31 points or 2^30 cells.
//   positions   world units
TetMesh delaunay(const std::vector<glm::dvec3>& positions);

// The positions in an order in which points that are near in space are near in memory, as in most meshes from
// simulations: along a Hilbert curve. Positions that coincide on delaunay()'s grid stay in their order.
std::vector<glm::dvec3> sortedAlongCurve(const std::vector<glm::dvec3>& positions);

}  // namespace tetralux
