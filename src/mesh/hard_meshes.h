// Meshes on which methods that sort cells by visibility go wrong, each in a way of its own. Double points; point array
// "scalar" with field(position) at the final places, which is also the preferred field.
#pragma once

#include <cstdint>

#include "mesh/field_function.h"
#include "mesh/tet_mesh.h"

namespace tetralux {

// Delaunay tetrahedra of random points, uniform in the unit cube, which they fill: its corners, edges and sides have
// points of their own, about as dense as the inside. Cells of all shapes, slivers among them. Has an exact order for
// every eye (Edelsbrunner 1990, "An acyclicity theorem for cell complexes in d dimensions"): by the power of the eye
// with respect to the circumspheres.
//   points   in all, at least 8: the corners; 5 cells each for 1000 points, 6 for 20,000, towards 6.77
//   seed     the same seed gives the same mesh on every machine
TetMesh randomDelaunay(std::uint32_t points, std::uint32_t seed, const FieldFunction& field = waveField);

// The same with z multiplied by `factor` afterwards: the same cells, now flat and no longer Delaunay, so that the
// order by circumspheres fails. Fills the box from the origin to (1, 1, factor); all cells are positive.
//   factor   > 0
TetMesh flattenedDelaunay(std::uint32_t points, std::uint32_t seed, double factor,
                          const FieldFunction& field = waveField);

// Random Delaunay tetrahedra as above in a column from (-1/2, -1/2, 0) to (1/2, 1/2, 3), then twisted about the z axis
// by an angle that grows with z, up to `turns` full turns. Not convex, not Delaunay, long visibility chains around the
// axis. Flat cells turn over where the twist bends them, and their neighbours overlap there; with seed 1 and
//     turns                            0    1/4   1/2   3/4    1     2
//     of   4,780 cells (1000 points)   0     40    71   125   187   469   are inverted,
//     of 119,271 cells (20,000)        0     80   205   352   555  1737
//   points   at least 8, the column's corners included
//   turns    any finite number; its sign is the sense of the twist, positive is anticlockwise seen from above
TetMesh twistedDelaunay(std::uint32_t points, std::uint32_t seed, double turns, const FieldFunction& field = waveField);

// A row of positive cells in the x direction, each sharing a face with the next and flatter than it by `heightRatio`.
// Cell k has the vertices k to k + 3; vertex k lies at (k / 2, k mod 2, (-q)^k), with q = heightRatio. Seen along z the
// cell is a parallelogram with sides of 1 and 1.1; the distance of its diagonals along z, its thickness, is
// q^k (1 + q)^2 (1 - q) / 2. Volumes are exact to 1e-14 of themselves while q^k is a normal number.
//   count         cells, >= 1
//   heightRatio   between 0 and 1, both excluded
TetMesh sliverChain(std::uint32_t count, double heightRatio, const FieldFunction& field = waveField);

// Three separate tetrahedra like sticks, about 4 long, no two of which touch. Seen along +z, or from an eye on the z
// axis at z <= -4, cell 1 hides a part of cell 0, cell 2 of cell 1, and cell 0 of cell 2: no order of whole cells is
// right. Seen along -z or from z >= 4 the cycle runs the other way. Coordinates are multiples of 1/16.
TetMesh cyclicTriple(const FieldFunction& field = waveField);

// The same in a convex mesh of 11 cells with matching faces: an octahedron cut into a twisted prism (Schoenhardt 1928),
// eight cells about its centre, and three cells around it. Nine cells form a cycle: seen along +z or from any eye on
// the z axis below the mesh (z < 0), cell k lies in front of cell (k + 1) mod 9, through the face that they share.
// Seen along -z or from above (z > 1) it runs the other way. Cells 9 and 10 are the caps at z = 0 and z = 1.
// Coordinates are multiples of 1/64, within 1 of the z axis.
TetMesh cyclicOctahedron(const FieldFunction& field = waveField);

}  // namespace tetralux
