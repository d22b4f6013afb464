#include "reference/ray_interval.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace tetralux::reference {
namespace {

// Sums of three products of rounded numbers are off by less than this share of the sum of their magnitudes.
constexpr double kSumRounding = 1e-15;

// Depths of one place, found with different faces and planes, differ by less than this share of them.
constexpr double kDepthRounding = 1e-12;

double magnitude(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(glm::abs(a), glm::abs(b)); }

}  // namespace

DepthRange keptRange(const std::vector<ClipPlane>& planes, const Ray& ray) {
  DepthRange range;
  for (const ClipPlane& plane : planes) {
    const double height = glm::dot(plane.normal, ray.origin) - plane.offset;
    const double slope = glm::dot(plane.normal, ray.direction);
    if (std::abs(slope) <= kSumRounding * magnitude(plane.normal, ray.direction)) {
      if (height < -kSumRounding * (magnitude(plane.normal, ray.origin) + std::abs(plane.offset))) return {0.0, 0.0};
    } else if (slope > 0.0) {
      range.low = std::max(range.low, -height / slope);
    } else {
      range.high = std::min(range.high, -height / slope);
    }
  }
  return range;
}

bool cutChord(CellChord& chord, const DepthRange& range) {
  const CellChord whole = chord;
  const CellSegment& segment = whole.segment;
  const double rounding = kDepthRounding * std::max(std::abs(segment.front), std::abs(segment.back));
  if (!(range.low < segment.back - rounding && range.high > segment.front + rounding && range.low < range.high))
    return false;
  const auto cut = [&](double depth, double& scalar, std::array<double, 4>& weights) {
    const double u = std::clamp((depth - segment.front) / (segment.back - segment.front), 0.0, 1.0);
    scalar = std::lerp(segment.sFront, segment.sBack, u);  // of equal ones exactly the same
    for (size_t i = 0; i < 4; i++) weights[i] = (1.0 - u) * whole.weightsFront[i] + u * whole.weightsBack[i];
    return depth;
  };
  if (range.low > segment.front + rounding)
    chord.segment.front = cut(range.low, chord.segment.sFront, chord.weightsFront);
  if (range.high < segment.back - rounding)
    chord.segment.back = cut(range.high, chord.segment.sBack, chord.weightsBack);
  return true;
}

}  // namespace tetralux::reference
