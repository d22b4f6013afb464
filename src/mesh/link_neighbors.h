// Cells paired at the faces that they share.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "mesh/tet_mesh.h"

namespace tetralux {

// For every cell the one across each of its faces, numbered and defined as in Adjacency::neighbors.
//   onLink   called once for each shared face, from several threads, with 4 cell + face of its two sides
// Linear in the mesh; 8 bytes per cell and 8 per point beside the result.
std::vector<std::array<std::uint32_t, 4>> linkNeighbors(
    const TetMesh& mesh, const std::function<void(std::uint32_t, std::uint32_t)>& onLink);

}  // namespace tetralux
