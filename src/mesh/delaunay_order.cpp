#include "mesh/delaunay_order.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "mesh/random.h"

namespace tetralux {
namespace {

constexpr int kBits = 21;  // of a coordinate: kGridSize = 2^20 is one of them

// Each point stays out of the last round with probability 1/8, out of the last two with 1/64, ...
constexpr int kRoundBits = 3;
constexpr int kRounds = 12;  // 8^11 > 2^32: the first round is small for any number of points

// How many rounds before the last one a point is inserted.
int roundsEarly(std::uint64_t key) { return std::min(kRounds - 1, std::countr_zero(mixBits(key)) / kRoundBits); }

}  // namespace

// Skilling's transform, from the highest bit down: where an axis has the bit, the lower bits of the first axis are
// mirrored; where it has not, they change places with those of the first axis. That undoes the turns of the curve;
// what remains is the Gray code of the place.
std::uint64_t hilbertIndex(const GridPoint& point) {
  std::uint32_t axes[3] = {static_cast<std::uint32_t>(point.x), static_cast<std::uint32_t>(point.y),
                           static_cast<std::uint32_t>(point.z)};
  for (std::uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1) {
    const std::uint32_t lower = bit - 1;
    for (std::uint32_t& axis : axes) {
      if (axis & bit) {
        axes[0] ^= lower;
      } else {
        const std::uint32_t difference = (axes[0] ^ axis) & lower;
        axes[0] ^= difference;
        axis ^= difference;
      }
    }
  }
  axes[1] ^= axes[0];
  axes[2] ^= axes[1];
  std::uint32_t flips = 0;
  for (std::uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1) {
    if (axes[2] & bit) flips ^= bit - 1;
  }
  std::uint64_t index = 0;
  for (int shift = kBits - 1; shift >= 0; shift--) {
    for (const std::uint32_t axis : axes) index = index << 1 | ((axis ^ flips) >> shift & 1);
  }
  return index;
}

std::vector<std::uint32_t> insertionOrder(const std::vector<GridPoint>& points) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> curve(points.size());
  for (size_t i = 0; i < points.size(); i++) curve[i] = {hilbertIndex(points[i]), static_cast<std::uint32_t>(i)};
  std::sort(curve.begin(), curve.end());
  const auto samePlace = [](const auto& a, const auto& b) { return a.first == b.first; };
  curve.erase(std::unique(curve.begin(), curve.end(), samePlace), curve.end());

  size_t roundStart[kRounds + 1] = {};
  for (const auto& [key, point] : curve) roundStart[kRounds - roundsEarly(key)]++;
  for (int round = 0; round < kRounds; round++) roundStart[round + 1] += roundStart[round];
  std::vector<std::uint32_t> order(curve.size());
  for (const auto& [key, point] : curve) order[roundStart[kRounds - 1 - roundsEarly(key)]++] = point;
  return order;
}

}  // namespace tetralux
