// The table behind include/integration/ppi.glsl: Psi over gamma_b and gamma_f (Moreland and Angel 2004, equation 12).
//
//     Psi = int_0^1 exp(-b u - (a - b) u^2/2) du,   a = gamma_b/(1 - gamma_b),  b = gamma_f/(1 - gamma_f)
//
// by Gauss and Legendre's rule of six points on panels of equal optical depth, at most 1 each: error below 1e-9 per panel,
// beside rounding. Where the optical depth is beyond 18, what is left out is below 2e-8.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/integration.h"
#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

#define TABLE_WORDS 0
#include "include/dispatch.glsl"
#include "include/table_store.glsl"

layout(push_constant, scalar) uniform Push { TableParameters table; };

const float kDeepest = 18.0;
const vec3 kNodes = vec3(0.2386191861, 0.6612093865, 0.9324695142);
const vec3 kWeights = vec3(0.4679139346, 0.3607615730, 0.1713244924);

float psi(float a, float b) {
  const float reach = min(0.5 * a + 0.5 * b, kDeepest);
  const float panels = max(ceil(reach), 1.0);
  float sum = 0.0;
  float u0 = 0.0;
  for (float k = 1.0; k <= kDeepest; k += 1.0) {
    // The u at which the optical depth from the front is t: the root of (a - b) u^2/2 + b u = t that does not cancel.
    const float t = reach * k / panels;
    const float root = sqrt(max(0.0, b * b + 2.0 * (a - b) * t));
    const bool isLast = k >= panels;
    const float u1 = isLast && reach < kDeepest ? 1.0 : min(1.0, 2.0 * t / max(b + root, 1e-30));
    const float halfWidth = 0.5 * (u1 - u0);
    const float middle = 0.5 * (u0 + u1);
    for (int i = 0; i < 3; i++) {
      const float low = middle - halfWidth * kNodes[i];
      const float high = middle + halfWidth * kNodes[i];
      sum += halfWidth * kWeights[i] *
             (exp(-low * (b * (1.0 - 0.5 * low) + 0.5 * a * low)) + exp(-high * (b * (1.0 - 0.5 * high) + 0.5 * a * high)));
    }
    u0 = u1;
    if (isLast) break;
  }
  return sum;
}

void main() {
  const uint index = linearIndex();
  if (4u * index >= table.width * table.height) return;
  vec4 value;
  for (uint i = 0; i < 4u; i++) {
    const uint texel = 4u * index + i;
    const uvec2 at = uvec2(texel % table.width, texel / table.width);
    // gamma/(1 - gamma) with gamma = i/(n - 1); an infinite depth lets nothing through.
    const vec2 left = vec2(table.width - 1u, table.height - 1u) - vec2(at);
    const vec2 depth = vec2(at) / max(left, vec2(1e-30));
    value[i] = any(lessThanEqual(left, vec2(0.0))) ? 0.0 : psi(depth.x, depth.y);
  }
  storeFour(index, value);
}
