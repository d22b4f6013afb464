// A mesh in an order that suits caches.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/tet_mesh.h"

namespace tetralux {

// How far apart in memory is what lies together in space: the mean over cells (65536 of them, evenly chosen, where
// there are more) of the longest way between a cell's vertices in the list of points, and of the way to the first
// vertex of the next cell, as a share of that list, whichever is longer. Near 0 along any curve that fills space; a
// third and more where points or cells are in random order. 0 for an empty mesh.
double memorySpread(const TetMesh& mesh);

// Numbers points along a Hilbert curve (Skilling 2004) through the mesh's box, and cells by the lowest of their new
// vertices, in the order they had. All arrays follow; nothing else changes. Memory for one array more while it runs.
void orderAlongCurve(TetMesh& mesh);

// The mesh with points and cells in random order, for tests of what that costs.
void shuffle(TetMesh& mesh, std::uint64_t seed);

}  // namespace tetralux
