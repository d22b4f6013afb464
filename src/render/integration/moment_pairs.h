// Integrals over runs of whole pieces of a transfer function, for include/integration/moments.glsl.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

namespace tetralux::render {

// Pieces that a table of pairs is made for: its memory and time grow with their square (32 bytes a pair, 34 MB at
// 1024).
inline constexpr std::size_t kMostMomentPieces = 1024;

// Two texels for every pair i, j of pieces, at 2 (i n + j): T, K.rgb and Q.rgb of the pieces between them, i + 1 to j -
// 1; 0 where there is none. The first and the last piece, which have no end, are never between.
//   pieces   as in TransferTables: TRANSFER_PIECE_TEXELS per piece, at most kMostMomentPieces
std::vector<glm::vec4> makeMomentPairs(const std::vector<glm::vec4>& pieces);

}  // namespace tetralux::render
