#include "reference/segment_links.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetralux::reference {
namespace {

// Share of the largest depth by which depths of one place may differ: faces seen edge-on multiply rounding. Taking the
// scalar of a place beside it by mistake would do no harm, because it hardly differs.
constexpr double kDepthTolerance = 1e-9;

}  // namespace

std::vector<std::uint32_t> predecessors(std::span<const CellSegment> segments, double scalarTolerance) {
  double farthest = 0.0;
  for (const CellSegment& s : segments) farthest = std::max(farthest, s.back);
  const double depthTolerance = kDepthTolerance * farthest;
  std::vector<std::uint32_t> byEnd(segments.size());
  std::iota(byEnd.begin(), byEnd.end(), 0u);
  std::sort(byEnd.begin(), byEnd.end(), [&](std::uint32_t a, std::uint32_t b) {
    return segments[a].back != segments[b].back ? segments[a].back < segments[b].back : a < b;
  });
  // Differences in units of what is tolerated; a tolerance of zero demands equality.
  const auto relative = [](double difference, double tolerance) {
    return difference == 0.0 ? 0.0 : std::abs(difference) / tolerance;
  };
  std::vector<std::uint32_t> result(segments.size(), kNoSegment);
  std::vector<bool> isContinued(segments.size(), false);
  for (std::uint32_t i = 0; i < segments.size(); i++) {
    const double front = segments[i].front;
    auto end = std::partition_point(byEnd.begin(), byEnd.end(),
                                    [&](std::uint32_t k) { return segments[k].back < front - depthTolerance; });
    double best = 2.0;
    for (; end != byEnd.end() && segments[*end].back <= front + depthTolerance; ++end) {
      if (*end >= i || isContinued[*end]) continue;
      const double scalars = relative(segments[*end].sBack - segments[i].sFront, scalarTolerance);
      const double distance = scalars + relative(segments[*end].back - front, depthTolerance);
      if (!(scalars <= 1.0) || !(distance < best)) continue;
      best = distance;
      result[i] = *end;
    }
    if (result[i] != kNoSegment) isContinued[result[i]] = true;
  }
  return result;
}

}  // namespace tetralux::reference
