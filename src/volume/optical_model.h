// The optical model: emission and absorption (Max 1995, "Optical Models for Direct Volume Rendering", section 4).
//
// Along a ray, with l the world length from the eye,
//
//     dI = L(s) tau(s) dl - tau(s) I dl
//
//   s     scalar, linear inside a tetrahedron
//   tau   extinction, 1/world unit, >= 0
//   L     linear light emitted per unit of extinction, rgb
//   I     light
//
// tau and L are piecewise linear in s between control points, constant outside them; two control points with the same
// s make a step, and s exactly on a step takes the values after it.
//
// One linear piece of length D, with f the end at the eye's side (front) and b the far end (back):
//
//     a = tau_b D,  b = tau_f D,  m = (a + b)/2          optical depths
//     zeta = exp(-m)                                     transmittance of the piece
//     Psi  = int_0^1 exp(-b u - (a - b) u^2/2) du        (Moreland and Angel 2004, equation 8, u from the front)
//     I    = I0 zeta + L_f (1 - zeta) + (L_b - L_f) (Psi - zeta)
//
// The last form is used throughout: 1 - zeta and Psi - zeta can be had with a small relative error for thin pieces,
// Psi itself cannot. A picture is premultiplied light I and alpha = 1 - zeta of the whole ray.
#pragma once

#include <glm/vec3.hpp>

namespace tetralux {

// What the transfer function says at one scalar value.
struct OpticalSample {
  glm::dvec3 luminance{0.0};  // L, linear rgb
  double extinction = 0.0;    // tau, 1/world unit
};

// Light and opacity of a ray's segment: I = light + (1 - alpha) * I0.
struct SegmentOptics {
  glm::dvec3 light{0.0};
  double alpha = 0.0;
};

}  // namespace tetralux
