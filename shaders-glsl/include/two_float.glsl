// Sums and products of floats without rounding error: value + rest is exact, and value is the rounded result. They hang on
// every operation being rounded by itself, hence `precise`. Denormal rests may be lost.
struct TwoFloat {
  float value;
  float rest;
};

// Knuth 1969, "The Art of Computer Programming", volume 2, 4.2.2.
TwoFloat twoSum(float a, float b) {
  precise const float value = a + b;
  precise const float bPart = value - a;
  precise const float aPart = value - bPart;
  precise const float rest = (a - aPart) + (b - bPart);
  return TwoFloat(value, rest);
}

// The upper 12 bits of a float (Veltkamp 1968), |a| < 2^115.
float upperHalf(float a) {
  precise const float scaled = 4097.0 * a;
  precise const float less = scaled - a;
  precise const float upper = scaled - less;
  return upper;
}

// Dekker 1971, "A floating-point technique for extending the available precision". No fma(): Vulkan allows it to round twice.
TwoFloat twoProduct(float a, float b) {
  precise const float value = a * b;
  precise const float aUpper = upperHalf(a);
  precise const float aLower = a - aUpper;
  precise const float bUpper = upperHalf(b);
  precise const float bLower = b - bUpper;
  precise const float rest = ((aUpper * bUpper - value) + aUpper * bLower + aLower * bUpper) + aLower * bLower;
  return TwoFloat(value, rest);
}
