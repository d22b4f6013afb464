// The demo: a wave function of the hydrogen atom on a graded mesh.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "mesh/tet_mesh.h"

namespace tetralux {

// Radius of the ball, Bohr radii. At its border the electron's density is below 3.1e-4 of its largest value.
constexpr double kOrbitalRadius = 45.0;

// The electron's wave function in a hydrogen atom's 4d z2 orbital (n = 4, l = 2, m = 0), divided by its largest
// magnitude: 1 at its two maxima, which lie on the z axis at r = 12 - 4 sqrt(3) = 5.07; zero on the sphere r = 12 and
// on the cone of 54.7 degrees about the z axis.
//   position   Bohr radii, from the nucleus
double orbital4dz2(const glm::dvec3& position);

// orbital4dz2 on a ball about the nucleus: a Delaunay mesh whose edges are four times as long at the border as at the
// nucleus, which is a point. Point arrays "psi" (orbital4dz2 at the point, preferred) and "density" (its square).
// Lengths in Bohr radii. All points of the border lie on the sphere, up to delaunay()'s rounding.
// Throws CheckFailure for `cells` out of range.
//   cells   1000 to 10^9, met within 10 %
//   seed    turns the points' shells; the same seed gives the same mesh, up to the rounding of the machine's sine
TetMesh hydrogenOrbital(std::uint64_t cells, std::uint32_t seed);

}  // namespace tetralux
