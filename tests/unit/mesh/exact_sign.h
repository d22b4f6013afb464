// The sign of a determinant without any rounding: what adaptive predicates are measured against.
#pragma once

#include <glm/vec3.hpp>

namespace tetralux::test {

struct ExactDeterminant {
  int sign = 0;
  double value = 0.0;  // to rounding
};

// (b - a) . ((c - a) x (d - a)), exactly. Coordinates within 2^-250 and 2^250, or zero, so that no product of three
// leaves the range of normal numbers with all its digits.
ExactDeterminant exactOrientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

}  // namespace tetralux::test
