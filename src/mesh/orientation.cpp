#include "mesh/orientation.h"

#include <cmath>

namespace tetralux {
namespace {

template <typename Real>
struct Determinant {
  Real value;
  Real permanent;  // the same sum with all terms positive: rounding is proportional to it
};

template <typename Real>
Determinant<Real> determinant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  const auto difference = [&](const glm::dvec3& p, int axis) { return Real(p[axis]) - Real(a[axis]); };
  const auto absolute = [](Real x) { return x < Real(0) ? -x : x; };
  const Real bx = difference(b, 0), by = difference(b, 1), bz = difference(b, 2);
  const Real cx = difference(c, 0), cy = difference(c, 1), cz = difference(c, 2);
  const Real dx = difference(d, 0), dy = difference(d, 1), dz = difference(d, 2);
  const Real value = bx * (cy * dz - cz * dy) + by * (cz * dx - cx * dz) + bz * (cx * dy - cy * dx);
  const Real permanent = absolute(bx) * (absolute(cy * dz) + absolute(cz * dy)) +
                         absolute(by) * (absolute(cz * dx) + absolute(cx * dz)) +
                         absolute(bz) * (absolute(cx * dy) + absolute(cy * dx));
  return {value, permanent};
}

template <typename Real>
int decidedSign(const Determinant<Real>& d, Real relativeError) {
  const Real bound = relativeError * d.permanent;
  return d.value > bound ? 1 : d.value < -bound ? -1 : 0;
}

}  // namespace

int orientationSign(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  // Seven roundings on the longest way from a coordinate to the sum; 2^-53 each, and some to spare.
  if (const int sign = decidedSign(determinant<double>(a, b, c, d), 8 * 0x1p-53)) return sign;
  __extension__ using Quadruple = __float128;
  return decidedSign(determinant<Quadruple>(a, b, c, d), Quadruple(8 * 0x1p-113));
}

}  // namespace tetralux
