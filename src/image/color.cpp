#include "image/color.h"

#include <cmath>
#include <glm/matrix.hpp>

namespace tetralux {
namespace {

// XYZ with Y = 1 of a chromaticity.
glm::dvec3 xyzOf(double x, double y) { return {x / y, 1.0, (1.0 - x - y) / y}; }

// Every column is the light of one primary, scaled so that the three make the white point, and white is the unit.
glm::dmat3 primariesOverWhite() {
  const glm::dmat3 primaries(xyzOf(0.64, 0.33), xyzOf(0.30, 0.60), xyzOf(0.15, 0.06));
  const glm::dvec3 white = xyzOf(0.3127, 0.3290);
  const glm::dvec3 shares = glm::inverse(primaries) * white;
  glm::dmat3 result;
  for (int i = 0; i < 3; i++) result[i] = primaries[i] * shares[i] / white;
  return result;
}

// The cube root, continued by its tangent below (6/29)^3 (CIE 15:2004, CIE 1976 L*a*b* space).
double labCurve(double t) {
  constexpr double kKnee = 6.0 / 29.0;
  return t > kKnee * kKnee * kKnee ? std::cbrt(t) : t / (3.0 * kKnee * kKnee) + 4.0 / 29.0;
}

}  // namespace

double srgbFromLinear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double linearFromSrgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

const glm::dmat3& relativeXyzFromRgb() {
  static const glm::dmat3 matrix = primariesOverWhite();
  return matrix;
}

const glm::dmat3& rgbFromRelativeXyz() {
  static const glm::dmat3 matrix = glm::inverse(primariesOverWhite());
  return matrix;
}

glm::dvec3 labFromRelativeXyz(const glm::dvec3& xyz) {
  const double x = labCurve(xyz.x);
  const double y = labCurve(xyz.y);
  const double z = labCurve(xyz.z);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

}  // namespace tetralux
