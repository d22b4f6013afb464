// Whether a range of scalars shows: has extinction or emission anywhere in it.
//
// Before including: SUPPORT_INTERVALS is a binding number.
layout(binding = SUPPORT_INTERVALS) uniform samplerBuffer supportIntervals;  // xy: scalars between which something shows

// Floats as integers of the same order.
int ordered(float value) {
  const int bits = floatBitsToInt(value);
  return bits >= 0 ? bits : bits ^ 0x7fffffff;
}

//   count   of intervals
bool isInSupport(float low, float high, uint count) {
  bool found = false;
  // A bound that is not just a uniform: Mesa's software device compiles a shader anew for every value of such a bound.
  count = min(count, uint(textureSize(supportIntervals)));
  for (uint i = 0; i < count; i++) {
    const vec2 interval = texelFetch(supportIntervals, int(i)).xy;
    // An interval that begins at a step at 0 begins with the largest number below it, which devices may take for 0.
    found = found || (low < interval.y && ordered(high) > ordered(interval.x));
  }
  return found;
}
