// A mesh turned about an oblique axis.
#pragma once

#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "mesh/tet_mesh.h"

namespace tetralux::test {

// Generated meshes have coordinates of few binary digits, and faces along the axes: sums of them hardly round. After
// the turn (a rotation matrix of fractions) nothing is level any more and every coordinate has all its digits.
//   mesh   double points
inline TetMesh tilted(TetMesh mesh) {
  constexpr double kTilt[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0.0}, {0.48, 0.64, 0.6}};
  for (glm::dvec3& p : std::get<std::vector<glm::dvec3>>(mesh.points)) {
    const glm::dvec3 q = p;
    for (int row = 0; row < 3; row++) p[row] = kTilt[row][0] * q.x + kTilt[row][1] * q.y + kTilt[row][2] * q.z;
  }
  return mesh;
}

}  // namespace tetralux::test
