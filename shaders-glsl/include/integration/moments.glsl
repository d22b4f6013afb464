// Opacity exactly, and light from two moments of the luminance over optical depth.
//
// With theta in [0, 1] the share of the segment's optical depth M that lies in front, light = int L(theta) M exp(-M theta)
// dtheta. L is projected on the first two Legendre polynomials, L ~ L0 + L1 (2 theta - 1):
//
//     L0 = K/T,  L1 = 3 (2 Q/T^2 - K/T),  light = (1 - zeta) (L0 - L1 (coth(M/2) - 2/M))
//
//   T = int tau ds,  K = int tau L ds,  Q = int tau L T_local ds, with T_local the part of T from the low end on
//
// over the scalars of the segment: a part of the piece of each end, and from a table all pieces between. No absolute integral
// is subtracted from another, so short intervals keep their digits. Error at most 0.016 M^3 times the range of L.

struct Moments {
  float t;
  vec3 k;
  vec3 q;
};

// A linear piece of width h: Q = L1 T^2/2 - (L1 - L0) h^2 (t0^2/6 + t0 dt/8 + dt^2/40).
Moments linearPiece(Optics low, Optics high, float h) {
  const float t0 = low.extinction, t1 = high.extinction, dt = t1 - t0;
  Moments m;
  m.t = 0.5 * h * (t0 + t1);
  m.k = h * ((t0 * low.luminance + t1 * high.luminance) * (1.0 / 3.0) +
             (t0 * high.luminance + t1 * low.luminance) * (1.0 / 6.0));
  m.q = 0.5 * m.t * m.t * high.luminance -
        (high.luminance - low.luminance) * (h * h * (t0 * t0 * (1.0 / 6.0) + t0 * dt * 0.125 + dt * dt * 0.025));
  return m;
}

Moments joined(Moments low, Moments high) {
  return Moments(low.t + high.t, low.k + high.k, low.q + high.q + low.t * high.k);
}

// All pieces between two, i < j.
Moments piecesBetween(int i, int j) {
  const int pieces = textureSize(transferPieces) / int(TRANSFER_PIECE_TEXELS);
  const int at = int(INTEGRATION_HEAD_TEXELS) + 2 * (i * pieces + j);
  const vec4 first = texelFetch(integrationNumbers, at);
  return Moments(first.x, first.yzw, texelFetch(integrationNumbers, at + 1).xyz);
}

vec4 integrateMoments(float front, float back, float thickness) {
  const float low = min(front, back);
  const float high = max(front, back);
  const int i = pieceOf(low);
  const int j = pieceOf(high);
  const Optics atLow = opticsInPiece(i, low);
  const Optics atHigh = opticsInPiece(j, high);
  // In one piece the width cancels, and is taken as 1: it may be 0.
  float width = 1.0;
  Moments m = linearPiece(atLow, atHigh, 1.0);
  if (i != j) {
    const float endOfFirst = texelFetch(transferPieces, 3 * i).y;
    const float startOfLast = texelFetch(transferPieces, 3 * j).x;
    const Moments first = linearPiece(atLow, opticsInPiece(i, endOfFirst), endOfFirst - low);
    const Moments last = linearPiece(opticsInPiece(j, startOfLast), atHigh, high - startOfLast);
    m = joined(joined(first, piecesBetween(i, j)), last);
    width = high - low;
  }
  if (front > back) m.q = m.t * m.k - m.q;

  const float depth = thickness * m.t / width;
  const float opacity = oneMinusExp(depth);
  const float perT = m.t > 0.0 ? 1.0 / m.t : 0.0;
  const vec3 mean = m.k * perT;
  const vec3 slope = 3.0 * (2.0 * (m.q * perT) * perT - mean);
  // coth x - 1/x; the series' first term left out is below 3e-8 at x = 0.5.
  const float x = 0.5 * depth;
  const float series = x * (1.0 / 3.0 - x * x * (1.0 / 45.0 - x * x * (2.0 / 945.0 - x * x * (1.0 / 4725.0))));
  const float tilt = x < 0.5 ? series : (2.0 - opacity) / max(opacity, 0.1) - 1.0 / max(x, 0.1);
  // Thick segments may overshoot.
  return vec4(max(opacity * (mean - slope * tilt), vec3(0.0)), opacity);
}
