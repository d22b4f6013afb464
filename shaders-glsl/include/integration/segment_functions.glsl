// Functions of one segment whose extinction is linear, for any optical depth.
#ifndef TETRALUX_INTEGRATION_SEGMENT_FUNCTIONS
#define TETRALUX_INTEGRATION_SEGMENT_FUNCTIONS

// (1 - exp(-m))/m by its Taylor series, for 0 <= m <= 0.5.
float thinMeanTransmittance(float m) {
  return 1.0 - m * (1.0 / 2.0) * (1.0 - m * (1.0 / 3.0) * (1.0 - m * (1.0 / 4.0) * (1.0 - m * (1.0 / 5.0) *
         (1.0 - m * (1.0 / 6.0) * (1.0 - m * (1.0 / 7.0))))));
}

// 1 - exp(-m), m >= 0, with a relative error below 3e-7 at any m: thousands of thin cells are summed.
float oneMinusExp(float m) { return m < 0.5 ? m * thinMeanTransmittance(m) : 1.0 - exp(-m); }

// (1 - exp(-m))/m, m >= 0, with the same relative error: the mean transmittance from the front of a segment of constant
// extinction to its places, 1 without extinction.
float meanTransmittance(float m) { return m < 0.5 ? thinMeanTransmittance(m) : (1.0 - exp(-m)) / m; }

// erfcx(x) = exp(x^2) erfc(x), x >= 0: polynomial in 1/(1 + 0.55 x), fitted where m > 1 needs it.
float scaledErfc(float x) {
  const float t = 1.0 / (1.0 + 0.55 * x);
  return t * (0.31030418 + t * (0.31018733 + t * (0.26672266 + t * (0.1386019 + t * (0.17720758 +
         t * (-0.30187506 + t * 0.09885568))))));
}

// V = Psi - zeta for optical depths a (back) and b (front), both from 0 to 1e8: largest error 4.6e-6, relative 2.7e-6 where
// (a + b)/2 <= 1. For larger depths with a > b the closed form of Williams and Max (1992, equation 13) written with
// erfcx, which neither overflows nor cancels; with a <= b a quotient of polynomials in 2/(a + b), fitted to the exact
// values.
float linearMoment(float a, float b) {
  const float m = 0.5 * a + 0.5 * b;
  const float p1 = 0.33333237 + a * (-0.099976953 + a * (0.017765454 + a * (-0.0021834529 + a * 0.00015626764)));
  const float p2 = 0.16666578 + a * (-0.17495593 + a * (0.050328199 + a * (-0.0084558776 + a * 0.00076457759)));
  const float p3 = -0.058313934 + a * (0.044986556 + a * (-0.012029666 + a * 0.0014810083));
  const float p4 = 0.011236086 + a * (-0.0072663196 + a * 0.0014069414);
  const float p5 = -0.0014452079 + a * 0.00064137307;
  if (m <= 1.0) return a * p1 + b * (p2 + b * (p3 + b * (p4 + b * (p5 + b * 0.00010493288))));
  const float zeta = exp(-m);
  if (a > b) {
    const float root = inversesqrt(max(0.5 * (a - b), 1e-8 * m * m));
    return 0.886226925 * root * (scaledErfc(0.5 * b * root) - zeta * scaledErfc(0.5 * a * root)) - zeta;
  }
  const float t = 1.0 / m;
  const float e = 0.5 * (b - a) * t;
  const float n = (0.00015639255 + e * (0.00020055699 + e * 3.6258162e-07)) +
                  t * ((0.00090871906 + e * (-0.00075272101 + e * -5.3956134e-05)) +
                  t * ((0.01120433 + e * (-0.00082302035 + e * 0.0011730157)) +
                  t * ((0.032351088 + e * (0.0062327065 + e * 0.00048405581)) +
                  t * (0.50016426 + e * (-0.1656313 + e * 0.00027439051)))));
  const float d = (0.00015620424 + e * (0.00035770098 + e * 0.00020118028)) +
                  t * ((0.00093648815 + e * (-0.00020666416 + e * -0.00091838457)) +
                  t * ((0.0098852085 + e * (0.0093114564 + e * 0.0038518217)) +
                  t * ((0.059943022 + e * (0.020724969 + e * -0.0020945703)) +
                  t * ((0.23231492 + e * (0.096322031 + e * 0.0023872843)) + t))));
  return (1.0 - zeta) * t * n / d;
}

#endif
