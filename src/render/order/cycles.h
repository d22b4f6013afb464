// Visibility cycles: what is left when peeling ends, on the host.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/visibility.h"

namespace tetralux::render {

// Slots of the drawing order: [first, end).
struct SlotSpan {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
};

// What peeling left behind (PeelStorage and the mesh's topology), per cell of the mesh.
struct PeelRemains {
  std::span<const std::uint32_t> waiting;                   // states
  std::span<const std::array<std::uint32_t, 4>> neighbors;  // cell across each face
  std::span<const std::uint32_t> relationHeads;             // empty: there are no relations
  std::span<const shared::Relation> relations;
  std::uint32_t levelCount = 0;  // levels that were peeled
};

struct CycleReport {
  std::uint64_t cyclicCells = 0;  // cells that are part of a cycle
  std::uint64_t apartCells = 0;   // cells to be composited per pixel
  std::vector<SlotSpan> apart;    // where these are in the drawing order, back to front
  std::uint32_t largestKey = 0;
};

// Gives a key to every cell that peeling left. Strongly connected components (Tarjan 1972) of the relation "in front
// of" with more than one cell are cycles; with each drawn as one, what is left is acyclic and gets levels like the
// rest. Cells of a cycle share one key that no other cell has. Linear in the cells that are left.
//   keys   of all cells, KEY_TRANSPARENT beside the level or KEY_OUTSIDE; those of peeled cells are final
CycleReport resolveCycles(const PeelRemains& remains, std::span<std::uint32_t> keys);

}  // namespace tetralux::render
