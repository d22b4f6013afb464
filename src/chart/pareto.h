// What is worth having of many that trade one cost for another.
#pragma once

#include <cstddef>
#include <vector>

namespace tetralux::chart {

struct Cost {
  double x = 0.0;  // less is better
  double y = 0.0;  // less is better
};

// Indices of the costs that no other one dominates (at most as large in both, smaller in one), by ascending x. Of equal
// costs the first is kept. A cost that is not finite is never a member.
std::vector<size_t> paretoFront(const std::vector<Cost>& costs);

}  // namespace tetralux::chart
