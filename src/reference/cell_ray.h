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

// The same part, and where its ends lie in the cell.
struct CellChord {
  CellSegment segment;
  std::array<double, 4> weightsFront{};  // barycentric: of the four vertices, >= 0, together 1
  std::array<double, 4> weightsBack{};
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

  // The same, with scalars made for comparisons: in a face the vertex that it lacks has no weight at all, and a place
  // between vertices of one value has exactly that value. A place nearer than 1e-12 of the cell to an edge or vertex is
  // taken to lie in it.
  bool intersect(const Ray& ray, CellChord& chord) const;

  // Of the scalar, which is linear in the cell: field units per world unit. The cell must not be empty.
  glm::dvec3 gradient() const;

 private:
  // Where a ray passes: barycentric coordinate i at depth base + t is (offset[i] + slope[i] t) / |volume6_|.
  struct Passage {
    double base = 0.0;
    std::array<double, 4> offset;
    std::array<double, 4> slope;
    double front = 0.0;  // t
    double back = 0.0;
    size_t faceFront = 4;  // the face, by the vertex opposite it; 4: the ray starts in the cell
    size_t faceBack = 4;
  };

  bool pass(const Ray& ray, Passage& passage) const;

  std::array<glm::dvec3, 4> vertices_;
  std::array<double, 4> scalars_;
  std::array<glm::dvec3, 4> normals_;  // of the face opposite each vertex, towards it; not of unit length
  double volume6_;                     // six times the volume, signed
};

}  // namespace tetralux::reference
