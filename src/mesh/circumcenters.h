// Centres of the spheres through the vertices of cells.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "mesh/tet_mesh.h"

namespace tetralux {

// The circumcentre of a tetrahedron relative to its first vertex: the point x with |x - v| = |x| for the other three
// vertices v relative to the first. World units; finite for
// vertices whose differences are.
//
// Computed from differences, in double precision or, where cancellation would cost it more than 12 of its bits
// (slivers), in 113-bit floats: the distances to the vertices agree to 2^-37 of the largest edge, as long as the radius
// is below 2^16 edges; beyond, to 2^-53 of the radius. A cell without a volume, up to the same rounding as in
// orientationSign(), or with a repeated vertex has no circumcentre and gets its centroid.
glm::dvec3 circumcenter(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

// The circumcentre of every cell relative to the cell's vertex of lowest index; the vertices are taken in ascending
// order of index, so a cell has one circumcentre to the last bit, however its vertices are listed. Runs on all
// processors.
std::vector<glm::dvec3> circumcenters(const TetMesh& mesh);

}  // namespace tetralux
