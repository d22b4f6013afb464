// The compare-exchange network of the bitonic merge sort (Batcher 1968, "Sorting networks and their applications").
//
// Level by level, ascending runs of 2^(k-1) pairs are merged in twos to ascending runs of 2^k: first each place of one run
// is compared with its mirror image in the other, then places are compared over strides of 2^(k-2), 2^(k-3), ... 1. All
// exchanges put the smaller pair in the lower place, so places beyond the last pair, if they held the largest pair of all,
// would keep it: nothing needs to be stored for them, and exchanges with them are left out.

// By key, equal keys by cell. No two pairs are equal, so the network, which keeps no order among equals, has one result.
bool isBefore(uvec2 a, uvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

// The lower of the two places that exchange p over a stride (a power of two) compares.
uint lowerPlace(uint p, uint stride) { return 2u * (p & ~(stride - 1u)) | (p & (stride - 1u)); }

// The higher one: the mirror image in a run of twice the stride, or a stride on.
uint higherPlace(uint low, uint stride, bool isMirrored) { return low ^ (isMirrored ? 2u * stride - 1u : stride); }
