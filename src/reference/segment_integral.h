// Light and opacity of one ray segment in double precision, by quadrature: the independent answer.
#pragma once

#include "volume/transfer_function.h"

namespace tetralux::reference {

// Integrates emission and absorption (volume/optical_model.h) along a segment on which the scalar is linear.
// Accurate to about 1e-14 whatever the optical depth.
//   sFront, sBack   scalar at the eye's end and at the far end
//   length          world units, >= 0
SegmentOptics integrateSegment(const TransferFunction& transfer, double sFront, double sBack, double length);

// V = Psi - zeta of one linear piece, in [0, 1 - zeta]: the light that a luminance rising from 0 at the front to 1 at
// the back sends to the eye.
//   depthFront, depthBack   extinction times length at the two ends (b and a in the literature), >= 0
double emissionMoment(double depthFront, double depthBack);

// What emission per length needs of one linear piece: how much of the light that is emitted along it, evenly or in
// proportion to the distance from its front, arrives at the eye.
struct LengthMoments {
  double even = 1.0;    // Psi = int_0^1 T(u) du, T the transmittance from the front to the share u of the piece
  double linear = 0.5;  // X = int_0^1 u T(u) du
};
LengthMoments lengthMoments(double depthFront, double depthBack);

}  // namespace tetralux::reference
