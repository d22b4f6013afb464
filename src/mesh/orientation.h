// On which side of a plane a point lies, decided reliably.
#pragma once

#include <glm/vec3.hpp>

namespace tetralux {

// Sign of (b - a) . ((c - a) x (d - a)): +1, -1, or 0 for four points in a plane. Double precision with an error bound
// (Shewchuk 1997, the first stage of orient3d), 113-bit floats where that does not decide; what is below their
// rounding, 1e-30 of the product of the edge lengths, counts as a plane.
int orientationSign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

}  // namespace tetralux
