#include "volume/factor_curve.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace tetralux {

FactorCurve::FactorCurve(std::vector<FactorPoint> points, std::string_view place) : points_(std::move(points)) {
  if (points_.empty()) fail(ErrorCode::Input, "{}: has no point, expected at least one", place);
  for (size_t i = 0; i < points_.size(); i++) {
    const FactorPoint& p = points_[i];
    const auto isFactor = [](double f) { return std::isfinite(f) && f >= 0.0; };
    if (!std::isfinite(p.value))
      fail(ErrorCode::Input, "{}: point {}: found {}, expected a finite number", place, i, p.value);
    for (const double factor : {p.factor, p.rgb.x, p.rgb.y, p.rgb.z}) {
      if (!isFactor(factor))
        fail(ErrorCode::Input, "{}: point {}: factor is {}, expected a finite number >= 0", place, i, factor);
    }
    if (i > 0 && p.value < points_[i - 1].value)
      fail(ErrorCode::Input, "{}: point {}: found {}, expected at least the value of the point before, {}", place, i,
           p.value, points_[i - 1].value);
  }
}

FactorPoint FactorCurve::at(double value) const {
  const auto after = std::upper_bound(points_.begin(), points_.end(), value,
                                      [](double v, const FactorPoint& point) { return v < point.value; });
  if (after == points_.begin()) return points_.front();
  const FactorPoint& low = *(after - 1);
  if (after == points_.end()) return low;
  const double t = (value - low.value) / (after->value - low.value);
  return {value, low.factor + t * (after->factor - low.factor), low.rgb + t * (after->rgb - low.rgb)};
}

}  // namespace tetralux
