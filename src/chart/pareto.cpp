#include "chart/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace tetralux::chart {

std::vector<size_t> paretoFront(const std::vector<Cost>& costs) {
  std::vector<size_t> order;
  for (size_t i = 0; i < costs.size(); i++) {
    if (std::isfinite(costs[i].x) && std::isfinite(costs[i].y)) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return std::tuple(costs[a].x, costs[a].y, a) < std::tuple(costs[b].x, costs[b].y, b);
  });
  std::vector<size_t> front;
  double lowest = std::numeric_limits<double>::infinity();
  for (const size_t i : order) {
    if (!(costs[i].y < lowest)) continue;
    lowest = costs[i].y;
    front.push_back(i);
  }
  return front;
}

}  // namespace tetralux::chart
