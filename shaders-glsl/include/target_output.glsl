// A layer's colour as the target wants it (shared/target_output.h).
//
// Before including: shared/spec_ids.h, shared/target_output.h.
layout(constant_id = SPEC_OUTPUT) const uint kOutput = 0;

// A permuted congruential generator's step as a hash (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering").
uint hashed(uint value) {
  const uint state = value * 747796405u + 2891336453u;
  const uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

// In [0, 1), the same for the same pixel and slot in every run.
float randomOf(uvec2 pixel, uint slot) {
  return float(hashed(pixel.x + hashed(pixel.y + hashed(slot))) >> 8) * (1.0 / 16777216.0);
}

// To multiples of 1/255, up with a probability equal to the fraction that is cut off. One random number for all channels:
// light stays below opacity where it was, and a layer's hue as near as 8 bits allow.
vec4 dithered(vec4 color, float random) {
  const vec4 levels = clamp(color, 0.0, 1.0) * 255.0;
  const vec4 low = floor(levels);
  return (low + vec4(greaterThan(levels - low, vec4(random)))) * (1.0 / 255.0);
}

//   slot   tells layers of one pixel apart
vec4 targetOutput(vec4 color, uvec2 pixel, uint slot) {
  if (kOutput == OUTPUT_DITHERED) return dithered(color, randomOf(pixel, slot));
  if (kOutput >= OUTPUT_ROUNDINGS) {
    if (color == vec4(0.0)) return color;  // nothing is blended, nothing rounded
    return vec4(1.0, 0.0, 0.0, kOutput == OUTPUT_ROUNDINGS ? color.a * (2.0 - color.a) : color.a);
  }
  return color;
}
