// One ray through one tetrahedron, in double precision, without regard to its neighbours.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "view/camera.h"

namespace tetralux::reference {

// The part of a ray inside a cell. Depths along the ray (Ray::direction), 0 <= front < back.
struct CellSegment {
  double front = 0.0;
  double back = 0.0;
  double sFront = 0.0;
  double sBack = 0.0;
};

// A tetrahedron prepared for rays: its faces' planes and its scalar.
class CellGeometry {
 public:
  //   vertices   world
  //   scalars    at the vertices
  CellGeometry(const std::array<glm::dvec3, 4>& vertices, const std::array<double, 4>& scalars);

  // A cell of zero volume meets no ray.
  bool empty() const { return volume6_ == 0.0; }

  // Whether the ray passes through the inside in front of its origin; then `segment` is set.
  bool intersect(const Ray& ray, CellSegment& segment) const;

 private:
  std::array<glm::dvec3, 4> vertices_;
  std::array<double, 4> scalars_;
  std::array<glm::dvec3, 4> normals_;  // of the face opposite each vertex, towards it; not of unit length
  double volume6_;                     // six times the volume, signed
};

}  // namespace tetralux::reference
