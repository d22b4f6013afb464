// A factor that depends on one number.
#pragma once

#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

namespace tetralux {

struct FactorPoint {
  double value = 0.0;
  double factor = 1.0;  // of extinction, >= 0
  glm::dvec3 rgb{1.0};  // of luminance, >= 0
};

// Piecewise linear between points, constant outside; two points of the same value make a step, and a value exactly on a
// step takes what comes after it.
class FactorCurve {
 public:
  FactorCurve() : points_{FactorPoint{}} {}

  // Throws Error(Input) beginning with `place` when there is no point, a number is not finite or a factor negative, or
  // values decrease from one point to the next.
  FactorCurve(std::vector<FactorPoint> points, std::string_view place);

  const std::vector<FactorPoint>& points() const { return points_; }
  FactorPoint at(double value) const;

 private:
  std::vector<FactorPoint> points_;
};

}  // namespace tetralux
