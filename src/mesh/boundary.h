// The faces of a mesh that do not join two cells.
#pragma once

#include <vector>

#include "mesh/adjacency.h"

namespace tetralux {

// Adjacency::boundary from its neighbours and sides.
std::vector<BoundaryFace> listBoundary(const TetMesh& mesh, const Adjacency& adjacency);

// Of the whole boundary of a mesh without folds: Adjacency::isConvex.
bool isConvexSurface(const TetMesh& mesh, const std::vector<BoundaryFace>& faces);

}  // namespace tetralux
