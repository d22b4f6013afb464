// Places where rays from the centre of a sphere cross the isosurface of its distance field.
#pragma once

#include <span>
#include <vector>

#include "mesh/tet_mesh.h"

namespace tetralux::test {

struct SpherePoint {
  CellVertices cell;
  std::array<double, 4> weights;  // of the cell's vertices: its barycentric coordinates
  glm::dvec3 normal;              // of the sphere there, length 1
};

// Uniform random directions; every ray crosses the isosurface once where the field is a distance.
//   distances   from `center`, one per point of the mesh
std::vector<SpherePoint> spherePoints(const TetMesh& mesh, std::span<const double> distances, const glm::dvec3& center,
                                      double radius, size_t count);

// Angle, in degrees, between the normal and vectors at vertices interpolated linearly to the place; ascending.
std::vector<double> anglesToNormals(const std::vector<SpherePoint>& points, std::span<const glm::dvec3> vectors);

}  // namespace tetralux::test
