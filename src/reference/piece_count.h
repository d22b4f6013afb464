// What cutting at the transfer function's control points costs: Moreland and Angel 2004, section 3.2 and table 1.
#pragma once

#include <cstdint>

#include "mesh/tet_mesh.h"
#include "volume/transfer_function.h"

namespace tetralux::reference {

// Linear pieces of a scalar range: one more than there are control points strictly inside it. Control points of equal s
// count as one.
//   a, b   the range's ends, in any order
std::uint32_t pieceCount(const TransferFunction& transfer, double a, double b);

// Sum over all cells of the pieces between their smallest and largest scalar: the cells there are after clipping each
// at every control point inside.
std::uint64_t cellPieceCount(const TetMesh& mesh, const ScalarField& field, const TransferFunction& transfer);

}  // namespace tetralux::reference
