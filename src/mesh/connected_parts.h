// Which cells hang together, and how they are folded.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/adjacency.h"

namespace tetralux {

// Cells that may take the space of others: those on the smaller side of the folds of the largest connected part, and
// all of every other part. Folded faces separate the sides. Empty where there is one part without folds; otherwise one
// bit for each cell.
std::vector<bool> cellsThatMayOverlap(const Adjacency& adjacency);

}  // namespace tetralux
