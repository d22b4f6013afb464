// Generated meshes: fixtures for tests and benchmarks, and the demo, without downloads.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>

#include "mesh/tet_mesh.h"

namespace tetralux {

// A scalar at a place in the world.
using FieldFunction = std::function<double(const glm::dvec3& position)>;

// nx x ny x nz cubes between `low` and `high`, six tetrahedra each (Kuhn 1960), all positive; neighbours match.
// Double points; point array `fieldName` with field(position).
//   nx, ny, nz   >= 1
TetMesh kuhnGrid(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz, const glm::dvec3& low, const glm::dvec3& high,
                 const FieldFunction& field, const std::string& fieldName = "scalar");

// The same with every inner vertex moved by up to `jitter` of its cube's edge along each axis. No cell turns over for
// jitter <= 0.1.
TetMesh jitteredGrid(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz, const glm::dvec3& low,
                     const glm::dvec3& high, double jitter, std::uint32_t seed, const FieldFunction& field,
                     const std::string& fieldName = "scalar");

// Delaunay tetrahedra of a point set, all positive. Points are first rounded to a grid of 2^-20 of the set's extent, on which
// the predicates are exact; points that then coincide are dropped. Double points (the rounded places).
// The result does not depend on the machine. Throws CheckFailure when fewer than four points span a volume.
//   positions   world units, finite
TetMesh delaunay(const std::vector<glm::dvec3>& positions);

// Adds a point array with field(position) for every point.
void addPointField(TetMesh& mesh, const std::string& name, const FieldFunction& field);

// The demo: the electron's wave function in a hydrogen atom's 4d z2 orbital (an analytic solution of the Schroedinger
// equation) on a ball, Delaunay mesh of about `cells` cells whose size grows with the distance from the nucleus.
// Lengths in Bohr radii; point arrays "psi" (the orbital, scaled to a largest magnitude of 1) and "density" (its
// square).
//   cells   >= 1000, met within 10 %
TetMesh hydrogenOrbital(std::uint64_t cells, std::uint32_t seed);

}  // namespace tetralux
