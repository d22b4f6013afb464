// The optical model: emission and absorption (Max 1995, "Optical Models for Direct Volume Rendering", section 4).
//
// Along a ray, with l the world length from the eye,
//
//     dI = L(s) tau(s) dl - tau(s) I dl      emission per extinction: particles that glow also absorb
//     dI = E(s) dl        - tau(s) I dl      emission per length (Wilhelms and Van Gelder 1991): independent of each
//     other
//
//   s     scalar, linear inside a tetrahedron
//   tau   extinction, 1/world unit, >= 0
//   L     linear light emitted per unit of extinction, rgb
//   E     linear light emitted per world unit, rgb
//   I     light
//
// tau, L and E are piecewise linear in s between control points, constant outside them; two control points with the
// same s make a step, and s exactly on a step takes the values after it.
//
// One linear piece of length D, with f the end at the eye's side (front) and b the far end (back):
//
//     a = tau_b D,  b = tau_f D,  m = (a + b)/2          optical depths
//     zeta = exp(-m)                                     transmittance of the piece
//     Psi  = int_0^1 exp(-b u - (a - b) u^2/2) du        (Moreland and Angel 2004, equation 8, u from the front)
//     I    = I0 zeta + L_f (1 - zeta) + (L_b - L_f) (Psi - zeta)
//
// The last form is used throughout: 1 - zeta and Psi - zeta can be had with a small relative error for thin pieces,
// Psi itself cannot. With emission per length, where nothing is small but D itself,
//
//     X = int_0^1 u exp(-b u - (a - b) u^2/2) du
//     I = I0 zeta + D (E_f Psi + (E_b - E_f) X)
//
// which needs no extinction: for tau = 0, Psi = 1 and X = 1/2. A picture is premultiplied light I and alpha = 1 - zeta
// of the whole ray; with emission per length, light may exceed alpha.
#pragma once

#include <glm/vec3.hpp>

namespace tetralux {

// What a transfer function's rgb stands for.
enum class Emission {
  PerExtinction,  // L: light per unit of extinction
  PerLength,      // E: light per world unit
};

// What the transfer function says at one scalar value.
struct OpticalSample {
  glm::dvec3 luminance{0.0};  // L or E (1/world unit), linear rgb
  double extinction = 0.0;    // tau, 1/world unit
};

// Light and opacity of a ray's segment: I = light + (1 - alpha) * I0.
struct SegmentOptics {
  glm::dvec3 light{0.0};
  double alpha = 0.0;
};

}  // namespace tetralux
