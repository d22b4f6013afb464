// The ternary truth table of projected cells, filled (see shaders-glsl/shared/truth_table.h for its form).
#pragma once

#include <array>
#include <cstdint>

#include "shared/truth_table.h"

namespace tetralux::render {

// Built from the rule, not written down: with P the vertices whose opposite face has a positive area, N negative and
// Z zero (areas of the four outward faces, which sum to zero),
//
//   class 1, |P| = 3 or |N| = 3: the vertex that stands alone is the centre, the others are the ring (8 cases)
//   class 2, |P| = |N| = 2: ring P0 N0 P1 N1, centre where the edges P0 P1 and N0 N1 cross (6 cases)
//   class 3, |Z| = 1: a vertex on an edge; the one that stands alone is the centre (24 cases)
//   class 4, |Z| = 2: two vertices at one place; one of them is the centre (12 cases)
//
// Everything else is the sign of no projection with an area: class 0, no triangles.
std::array<std::uint32_t, shared::TRUTH_TABLE_SIZE> makeTruthTable();

}  // namespace tetralux::render
