// Exact integration of one ray segment for a piecewise linear transfer function (volume/optical_model.h).
//
// The scalar is linear along the segment, so extinction and luminance are linear between the places where the scalar
// meets a control point. The segment is walked from the front, a part at a time; a part ends at the next control point
// or where its optical depth would exceed kLargestPartDepth, so that one polynomial is accurate for every part and no
// special function is needed.
// This is also Moreland and Angel's (2004, section 3.2) adaptive sampling: a sample at every control point.
//
// Before including: shared/integration.h, shared/spec_ids.h, and what transfer_pieces.glsl wants.
#ifndef TETRALUX_INTEGRATION_EXACT
#define TETRALUX_INTEGRATION_EXACT

#include "include/integration/transfer_pieces.glsl"

layout(constant_id = SPEC_PART_ACCURACY) const uint kPartAccuracy = PART_FULL;
// exp(-16): what lies behind adds less than a rounding error. A frame that may err by more leaves out more.
layout(constant_id = SPEC_LEAST_TRANSMITTANCE) const float kLeastTransmittance = 1.1e-7;

// Smaller parts are right with polynomials of a lower degree: most parts are thin, so that costs few rounds more.
const float kLargestPartDepth = kPartAccuracy == PART_FULL || kPartAccuracy == PART_FINE ? 0.5 : 1.0;
const int kMostParts = 1 << 20;       // more than any segment has
// With emission per length, what lies behind may be any number of times brighter than what lies in front: there the
// transmittance is kept as a product, with all its digits, and the walk ends where it is below this, exp(-28).
const float kLeastGlowTransmittance = 1e-12;

// (1 - exp(-m)) / m for 0 <= m <= kLargestPartDepth: polynomials fitted to the least relative error.
float relativeOpacity(float m) {
  if (kPartAccuracy == PART_COARSE) return 0.998891234 + m * (-0.48128441 + m * 0.115214661);
  if (kPartAccuracy == PART_MEDIUM) return 0.999945521 + m * (-0.498362511 + m * (0.158553019 + m * -0.0280499086));
  if (kPartAccuracy == PART_FINE) return 0.999996251 + m * (-0.499768514 + m * (0.164367534 + m * -0.0341450334));
  // In two halves (Estrin 1960), which are computed side by side.
  const float squared = m * m;
  return (0.999999922 + m * -0.499992483) + squared * ((0.166548037 + m * -0.0410009707) + squared * 0.00677075985);
}

// V = Psi - zeta for optical depths a (back) and b (front) with (a + b)/2 <= kLargestPartDepth: polynomials fitted to the exact
// values, with the least error relative to 1 - zeta.
float emissionMoment(float a, float b) {
  if (kPartAccuracy == PART_COARSE)
    return max(a * (0.325608253 + a * -0.0704976097) + b * (0.158950955 + a * -0.121014133 + b * -0.0356682651), 0.0);
  if (kPartAccuracy == PART_MEDIUM)
    return a * (0.332841069 + a * (-0.0958646908 + a * 0.0121670933)) +
           b * (0.166175216 + a * (-0.166964829 + a * 0.0341068953) +
                b * (-0.0547951683 + a * 0.0300969929 + b * 0.00707249343));
  if (kPartAccuracy == PART_FINE)
    return a * (0.333250983 + a * (-0.0987802194 + a * 0.0146727319)) +
           b * (0.166587354 + a * (-0.17266358 + a * 0.0413973845) +
                b * (-0.0572888764 + a * 0.0366823062 + b * 0.00891617392));
  return a * (0.333330867 + a * (-0.0999417798 + a * (0.0175853981 + a * -0.00188199539))) +
         b * (0.166664299 + a * (-0.174887107 + a * (0.0498017306 + a * -0.00727878305)) +
              b * (-0.0582814023 + a * (0.0444846556 + a * -0.0103313319) +
                   b * (0.0110873246 + a * -0.00621295563 + b * -0.00122143382)));
}

// X = int_0^1 u exp(-b u - (a - b) u^2/2) du, (a + b)/2 <= 1: polynomial of degree 5 fitted to the exact values, relative error
// 3.6e-7. Nothing vanishes for thin parts: X = 1/2 where a = b = 0.
float lengthMoment(float a, float b) {
  const float p0 = 0.49999982 + a * (-0.12499949 + a * (0.020832447 + a * (-0.0025991532 + a * (0.00025135197 + a * -1.5589365e-05))));
  const float p1 = -0.20832783 + a * (0.05831033 + a * (-0.0099957166 + a * (0.0012116804 + a * -8.8660912e-05)));
  const float p2 = 0.045803167 + a * (-0.013666039 + a * (0.0022865937 + a * -0.00020844216));
  const float p3 = -0.0068572955 + a * (0.0020340534 + a * -0.00025572765);
  const float p4 = 0.00073767197 + a * -0.00016576365;
  return p0 + b * (p1 + b * (p2 + b * (p3 + b * (p4 + b * -4.6314453e-05))));
}

// A square root, at most 7 % too large, and an inverse, at most 24 % too small, by the exponents' bits (Blinn 1997): a few instructions
// instead of two that take ten times as long.
float roughRoot(float x) { return 1.036 * uintBitsToFloat((floatBitsToUint(x) >> 1) + 0x1fbd1df5u); }
float roughInverse(float x) { return 0.88 * uintBitsToFloat(0x7ef311c7u - floatBitsToUint(x)); }

// How much of a part is kept where its optical depth would become too large for the polynomials: at most the share k at which
// e0 k + (e1 - e0) k^2/2, with e = extinction times length, reaches the limit. 1 for a part that need not be cut.
float keptShare(float extinction0, float extinction1, float part) {
  const float e0 = min(extinction0 * part, 1e18);
  const float change = min(extinction1 * part, 1e18) - e0;
  const float root = roughRoot(max(0.0, e0 * e0 + 2.0 * kLargestPartDepth * change));
  return e0 + 0.5 * change > kLargestPartDepth ? 2.0 * kLargestPartDepth * roughInverse(e0 + root) : 1.0;
}

// Composites a part on which extinction and luminance are linear behind light and opacity.
//   clearness   with emission per length: the transmittance so far
void addPart(float extinctionFront, float extinctionBack, vec3 luminanceFront, vec3 luminanceChange, float part,
             inout vec3 light, inout float opacity, inout float clearness) {
  const float depthFront = extinctionFront * part;
  const float depthBack = extinctionBack * part;
  const float depth = 0.5 * (depthFront + depthBack);
  const float partOpacity = depth * relativeOpacity(depth);
  const float transmittance = 1.0 - opacity;
  if (kEmissionPerLength) {
    const float psi = emissionMoment(depthBack, depthFront) + (1.0 - partOpacity);
    light += clearness * part * (luminanceFront * psi + luminanceChange * lengthMoment(depthBack, depthFront));
    clearness *= 1.0 - partOpacity;
  } else {
    light += transmittance * (luminanceFront * partOpacity + luminanceChange * emissionMoment(depthBack, depthFront));
  }
  opacity += transmittance * partOpacity;
}

// A segment that is being walked.
struct PartWalk {
  float front;      // normalised scalars at its ends
  float back;
  float thickness;  // length along the ray, mesh units, >= 0
  float rise;       // back - front
  float sharePerScalar;
  float share;      // how much of the segment has been walked, 0 to 1
  int piece;        // of the transfer function
  bool rising;
};

PartWalk beginParts(float front, float back, float thickness) {
  PartWalk walk;
  walk.front = front;
  walk.back = back;
  walk.thickness = thickness;
  walk.rise = back - front;
  walk.rising = back >= front;
  walk.sharePerScalar = walk.rise == 0.0 ? 0.0 : 1.0 / walk.rise;
  walk.share = 0.0;
  const int bin = clamp(int((front + 0.5) * float(TRANSFER_BINS)), 0, int(TRANSFER_BINS) - 1);
  walk.piece = int(texelFetch(transferPieceBins, 2 * bin + (walk.rising ? 0 : 1)).x);
  return walk;
}

// Composites the next part behind light and opacity. Returns whether it was the last one.
//   clearness   with emission per length: the transmittance so far, 1 at first
bool walkPart(inout PartWalk walk, inout vec3 light, inout float opacity, inout float clearness) {
  const vec4 range = texelFetch(transferPieces, 3 * walk.piece);
  const vec4 luminanceLow = texelFetch(transferPieces, 3 * walk.piece + 1);
  const vec3 luminanceSlope = texelFetch(transferPieces, 3 * walk.piece + 2).xyz;

  // The part of the segment inside the piece; empty where the walk has not reached the piece yet.
  const bool isLast =
      walk.rising ? (walk.rise > 0.0 ? range.y >= walk.back : range.y > walk.back) : range.x <= walk.back;
  const float scalarExit = walk.rising ? range.y : range.x;
  const float shareExit = isLast ? 1.0 : clamp((scalarExit - walk.front) * walk.sharePerScalar, walk.share, 1.0);

  const float s0 = clamp(walk.front + walk.share * walk.rise, range.x, range.y) - range.x;
  const float s1 = clamp(walk.front + shareExit * walk.rise, range.x, range.y) - range.x;
  const float extinction0 = range.z + range.w * s0;
  float extinction1 = range.z + range.w * s1;
  float part = (shareExit - walk.share) * walk.thickness;

  const float keep = keptShare(extinction0, extinction1, part);
  const bool isCut = keep < 1.0;
  part *= keep;
  const float s2 = mix(s0, s1, keep);
  extinction1 = mix(extinction0, extinction1, keep);

  addPart(extinction0, extinction1, luminanceLow.xyz + luminanceSlope * s0, luminanceSlope * (s2 - s0), part, light, opacity,
          clearness);

  walk.share = isCut ? mix(walk.share, shareExit, keep) : shareExit;
  walk.piece = isCut ? walk.piece : (walk.rising ? walk.piece + 1 : walk.piece - 1);
  return isLast && !isCut;
}

// Whether what lies behind adds nothing any more.
bool isWalkOpaque(float opacity, float clearness) {
  return kEmissionPerLength ? clearness <= kLeastGlowTransmittance : opacity >= 1.0 - kLeastTransmittance;
}

// Premultiplied light and opacity of a segment.
//   front, back   normalised scalars at its ends
//   thickness     length along the ray, mesh units, >= 0
vec4 integrateExact(float front, float back, float thickness) {
  PartWalk walk = beginParts(front, back, thickness);
  vec3 light = vec3(0.0);
  float opacity = 0.0;
  float clearness = 1.0;
  // Left from two places on purpose. In Mesa 22.3's software device a loop that is left at its head costs a round more, and
  // in one that is left only at its end, lanes that have finished come out with wrong values.
  for (int round = 0; round < kMostParts; round++) {
    const bool isLast = walkPart(walk, light, opacity, clearness);
    if (isLast || isWalkOpaque(opacity, clearness)) break;
  }
  return vec4(light, opacity);
}

#endif
