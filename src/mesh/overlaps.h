// Cells that take the same space: the mesh is turned over somewhere, or parts of it penetrate each other.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/adjacency.h"

namespace tetralux {

// Pairs of cells whose insides overlap, where one of them is turned over (on the side of folded faces where a connected
// part of the mesh has fewer cells) or belongs to another connected part than the largest: duplicates, meshes laid into
// each other. A connected part that penetrates itself without a fold is not found. Nothing but a walk over the cells
// where there is one part without folds; otherwise about a microsecond for each cell near a suspect.
std::vector<std::array<std::uint32_t, 2>> findOverlaps(const TetMesh& mesh, const Adjacency& adjacency);

}  // namespace tetralux
