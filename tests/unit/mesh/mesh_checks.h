// Exact checks of generated meshes, independent of the code that made them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/tet_mesh.h"

namespace tetralux::test {

__extension__ typedef __int128 Int128;

using IntPoint = std::array<std::int64_t, 3>;

// (b - a) x (c - a) . (d - a): six times the volume of (a, b, c, d). Exact for coordinates up to 2^40.
Int128 volume6(const IntPoint& a, const IntPoint& b, const IntPoint& c, const IntPoint& d);

// > 0 where p lies inside the sphere around the positive tetrahedron, 0 where on it. Exact for coordinates to 2^23.
Int128 insideSphere(const std::array<IntPoint, 4>& cell, const IntPoint& p);

// A mesh with whole-numbered coordinates.
struct IntMesh {
  std::vector<IntPoint> points;
  std::vector<CellVertices> cells;

  std::array<IntPoint, 4> corners(size_t cell) const;
};

// The mesh in units of `step`, a power of two. Throws std::runtime_error unless every coordinate is a whole number of
// steps.
IntMesh inSteps(const TetMesh& mesh, double step);

// What the faces and volumes of a mesh say.
struct Topology {
  size_t flatOrInverted = 0;  // cells of no positive volume
  size_t mismatched = 0;      // faces that two cells have from the same side, or more than two cells have
  std::vector<std::array<std::uint32_t, 3>> border;  // faces of one cell, anticlockwise seen from outside
  std::int64_t eulerNumber = 0;                      // points - edges + faces - cells, over used points
  size_t usedPoints = 0;
  Int128 volume6 = 0;

  // Positive cells with matching faces that make one solid ball.
  bool isBall() const { return flatOrInverted == 0 && mismatched == 0 && eulerNumber == 1; }
};
Topology topologyOf(const IntMesh& mesh);

// Whether every point lies behind or on every face of the border: with isBall(), the cells fill the convex hull.
bool bordersConvexHull(const IntMesh& mesh, const Topology& topology);

// Whether no point lies inside the sphere around any cell. Time proportional to points times cells.
bool isDelaunay(const IntMesh& mesh);

// Whether no point is inside both cells: looks for a plane between them, exactly (coordinates up to 2^20).
bool interiorsDisjoint(const std::array<IntPoint, 4>& a, const std::array<IntPoint, 4>& b);

}  // namespace tetralux::test
