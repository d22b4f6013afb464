// Colour spaces: the curve and primaries of sRGB (IEC 61966-2-1:1999), CIE XYZ and CIE L*a*b* relative to its white.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace tetralux {

// The curve of sRGB, linear light to encoded value and back. Defined from 0 up; 0 and 1 map to themselves exactly.
double srgbFromLinear(double linear);
double linearFromSrgb(double encoded);

// XYZ, each component divided by that of the white point (D65), from linear RGB: white is (1, 1, 1).
const glm::dmat3& relativeXyzFromRgb();
const glm::dmat3& rgbFromRelativeXyz();

// CIE 1976 L*a*b* of a colour given by relativeXyzFromRgb(). L is 0..100 for colours within sRGB.
glm::dvec3 labFromRelativeXyz(const glm::dvec3& xyz);

}  // namespace tetralux
