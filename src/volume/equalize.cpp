#include "volume/equalize.h"

#include <algorithm>
#include <cmath>

namespace tetralux {

TransferFunction equalizedOpacity(const std::vector<ControlPoint>& colors, const std::vector<WeightedScalar>& samples,
                                  double lengthWorld, double opticalDepth) {
  const size_t n = colors.size();
  // The share of the volume in each control point's hat function: what the point's extinction will act on.
  std::vector<double> share(n, 0.0);
  double total = 0.0;
  for (const WeightedScalar& sample : samples) {
    const auto above = std::upper_bound(colors.begin(), colors.end(), sample.s,
                                        [](double s, const ControlPoint& p) { return s < p.s; });
    const size_t hi = std::min<size_t>(static_cast<size_t>(above - colors.begin()), n - 1);
    const size_t lo = hi == 0 ? 0 : hi - 1;
    const double width = colors[hi].s - colors[lo].s;
    const double t = width > 0.0 ? std::clamp((sample.s - colors[lo].s) / width, 0.0, 1.0) : 0.0;
    share[lo] += sample.weight * (1.0 - t);
    share[hi] += sample.weight * t;
    total += sample.weight;
  }
  // Rare values are limited to 100 times the density of a value that fills the volume; otherwise a single noisy cell
  // would be drawn as an opaque speck.
  constexpr double kSmallestShare = 0.01;
  std::vector<ControlPoint> points = colors;
  double weightSum = 0.0;
  for (const ControlPoint& p : colors) weightSum += p.tau;
  for (size_t i = 0; i < n; i++) {
    const double fraction = total > 0.0 ? std::max(share[i] / total, kSmallestShare) : 1.0 / static_cast<double>(n);
    const double relative = weightSum > 0.0 ? colors[i].tau / weightSum : 0.0;
    points[i].tau = relative * opticalDepth / (lengthWorld * fraction);
  }
  return TransferFunction(std::move(points), "equalised transfer function");
}

}  // namespace tetralux
