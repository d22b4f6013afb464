// The device's coordinates: small numbers around zero, whatever the mesh's place, size and units.
#pragma once

#include <glm/vec3.hpp>

#include "mesh/tet_mesh.h"

namespace tetralux::render {

// Mesh space is (world - center) / scale, all points within [-1, 1]; scale is a power of two, so that dividing by it
// loses nothing. Scalars are normalised to (s - scalarCenter) / scalarRange, within [-0.5, 0.5]. Both are computed in
// double precision before anything is rounded to single.
struct MeshSpace {
  glm::dvec3 center{0.0};
  double scale = 1.0;  // world units per mesh unit
  double scalarCenter = 0.0;
  double scalarRange = 1.0;  // 1 for a constant field
  glm::dvec3 low{-1.0};      // the mesh's box, mesh space
  glm::dvec3 high{1.0};

  glm::dvec3 position(const glm::dvec3& world) const { return (world - center) / scale; }
  // The same as the device has it, and what that leaves of it.
  glm::vec3 roundedPosition(const glm::dvec3& world) const;
  glm::vec3 positionRest(const glm::dvec3& world) const;
  float scalar(double s) const;
};

MeshSpace makeMeshSpace(const TetMesh& mesh, const ScalarField& field);

}  // namespace tetralux::render
