// Sort keys from the power of the eye with respect to every cell's circumsphere (power distance), farthest first.
//
// The power |e - c|^2 - r^2 orders the cells of a Delaunay mesh, and of any part of one, exactly (Edelsbrunner 1990). Across
// a face it changes by 2 (c1 - c2) . (e - p), p any point of the face, which is nothing at all for cospherical cells and may
// be little for others. So it is computed relative to its mean over the mesh's box and nearly without rounding (the compensated
// dot product of Ogita, Rump and Oishi 2005), and keys are evenly spaced: 2^-28 of the powers' range over the box. Two
// neighbours then have the same key, or keys in the right order; for those with the same see power_ties.comp.
//
// Orthographic limit, divided by -2 |e|: the depth of the circumcentre.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/power_keys.h"
#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

layout(constant_id = SPEC_WIDE_ADDRESSING) const bool kWideAddressing = false;

#include "include/dispatch.glsl"
#include "include/two_float.glsl"

layout(binding = 0) uniform samplerBuffer sphereLeading;  // c, |c|^2 - r^2
layout(binding = 1) uniform usamplerBuffer sphereRest;    // what those four leave, snorm16 of 2^-24 of each
layout(binding = 2) uniform usamplerBuffer keysIn;        // the same buffer as:
layout(binding = 3, scalar) writeonly buffer Keys { uint keys[]; };

layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer LeadingAt { vec4 data[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer RestAt { uvec2 data[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer UintsAt { uint data[]; };
struct SphereAddresses {
  LeadingAt leading;
  RestAt rest;
};
layout(push_constant, scalar) uniform Push {
  SphereAddresses spheres;
  UintsAt keysAt;
  vec4 weights;  // share of c and |c|^2 - r^2 in the scaled power
  float offset;  // added to it
  uint cellCount;
};

TwoFloat scaledPower(uint cell) {
  const vec4 leading = kWideAddressing ? spheres.leading.data[cell] : texelFetch(sphereLeading, int(cell));
  const uvec2 packed = kWideAddressing ? spheres.rest.data[cell] : texelFetch(sphereRest, int(cell)).xy;
  const vec4 rest = vec4(unpackSnorm2x16(packed.x), unpackSnorm2x16(packed.y)) * abs(leading) * 5.9604645e-8;
  precise float value = offset;
  precise float small = 0.0;
  for (int i = 0; i < 4; i++) {
    const TwoFloat product = twoProduct(weights[i], leading[i]);
    const TwoFloat sum = twoSum(value, product.value);
    value = sum.value;
    small += sum.rest + product.rest + weights[i] * rest[i];
  }
  return twoSum(value, small);
}

const float kSteps = 268435456.0;  // 2^28

// Order-preserving map of scaled powers to the integers from -kSteps to kSteps, kSteps to a unit inside the box's range.
int spaced(TwoFloat power) {
  const float size = abs(power.value);
  if (size >= POWER_INSIDE) {
    // Floats as integers are logarithms, near enough; 2^25 steps are left for those up to the largest.
    const int steps = int((floatBitsToUint(size) - floatBitsToUint(POWER_INSIDE)) >> 5);
    const int place = int(POWER_INSIDE * kSteps) + min(steps, 0x1ffffff);
    return power.value < 0.0 ? -place : place;
  }
  precise const float value = power.value * kSteps;
  const float whole = floor(value);
  precise const float fraction = (value - whole) + power.rest * kSteps;
  return int(whole) + int(floor(fraction));
}

void main() {
  const uint cell = linearIndex();
  if (cell >= cellCount) return;
  const uint key = kWideAddressing ? keysAt.data[cell] : texelFetch(keysIn, int(cell)).x;
  if (key == KEY_OUTSIDE) return;
  // One less than there is room for: with KEY_TRANSPARENT, the largest key would be KEY_OUTSIDE.
  const int number = clamp(int(kSteps) - spaced(scaledPower(cell)), 0, 0x1ffffffe);
  const uint newKey = uint(number) << POWER_LEVEL_BITS | (key & KEY_TRANSPARENT);
  if (kWideAddressing)
    keysAt.data[cell] = newKey;
  else
    keys[cell] = newKey;
}
