// The order in which points are inserted into a growing triangulation.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/delaunay_predicates.h"

namespace tetralux {

// Place along the Hilbert curve through the grid of 2^21 places a side (Skilling 2004, "Programming the Hilbert
// curve"): a one-to-one number below 2^63, near for points that are near.
std::uint64_t hilbertIndex(const GridPoint& point);

// The points' numbers in a biased randomised insertion order (Amenta, Choi, Rote 2003, "Incremental constructions con
// BRIO"): random rounds of growing size, each along the Hilbert curve. The rounds' randomness bounds the expected work
// for points in bad order; the curve keeps the search for the next point short and the data in cache.
// Of points at the same place only the first is in the result.
std::vector<std::uint32_t> insertionOrder(const std::vector<GridPoint>& points);

}  // namespace tetralux
