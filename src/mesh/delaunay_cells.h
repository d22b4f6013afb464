// The triangulation itself: integer points in, tetrahedra out.
#pragma once

#include <vector>

#include "mesh/delaunay_predicates.h"
#include "mesh/tet_mesh.h"

namespace tetralux {

// The Delaunay tetrahedra of points at different places: they fill the convex hull, every volume is positive, every
// face has one or two cells, and no circumsphere holds a point. Among the many such meshes of cospherical points, it
// is the one that breakCosphericalTie() singles out, whatever the order of the points. The cells come in no useful
// order. About 40 bytes per cell.
// Throws CheckFailure when all points are coplanar, and for 2^31 points or 2^30 cells.
//   points   in the order of insertion; insertionOrder() makes a good one
std::vector<CellVertices> delaunayCells(const std::vector<GridPoint>& points);

}  // namespace tetralux
