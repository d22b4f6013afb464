// The tables that some methods look into. Entry i of n along an axis stands for the coordinate i/(n - 1).
//
// Before including: INTEGRATION_NUMBERS, INTEGRATION_TABLE_2D, INTEGRATION_TABLE_3D are binding numbers; shared/integration.h.

// INTEGRATION_HEAD_TEXELS texels of scales, then for `moments` two per pair of pieces.
layout(binding = INTEGRATION_NUMBERS) uniform samplerBuffer integrationNumbers;
layout(binding = INTEGRATION_TABLE_2D) uniform sampler2D integrationTable2d;
layout(binding = INTEGRATION_TABLE_3D) uniform sampler3D integrationTable3d;

// Where a device does not filter the table's format, or only with fractions of 8 bits that are too coarse for a test.
layout(constant_id = SPEC_TABLE_FETCH) const bool kTableFetch = false;

struct TableScale {
  vec4 value;               // what a table's entries are multiplied by
  float thickness;          // mesh units: 1 on the table's axis of thickness, or the one thickness that it is made for
  float largestExtinction;  // 1/mesh unit: 1 on an axis of extinction
};

TableScale tableScale() {
  const vec4 first = texelFetch(integrationNumbers, 0);
  return TableScale(vec4(first.zzz, first.w), first.x, first.y);
}

//   at   0 to 1 along each axis, held to that
vec4 sampleTable2d(vec2 at) {
  const ivec2 size = textureSize(integrationTable2d, 0);
  const vec2 texel = clamp(at, 0.0, 1.0) * vec2(size - 1);
  if (!kTableFetch) return textureLod(integrationTable2d, (texel + 0.5) / vec2(size), 0.0);
  const ivec2 low = min(ivec2(texel), max(size - 2, ivec2(0)));
  const ivec2 high = min(low + 1, size - 1);
  const vec2 f = texel - vec2(low);
  return mix(mix(texelFetch(integrationTable2d, low, 0), texelFetch(integrationTable2d, ivec2(high.x, low.y), 0), f.x),
             mix(texelFetch(integrationTable2d, ivec2(low.x, high.y), 0), texelFetch(integrationTable2d, high, 0), f.x),
             f.y);
}

vec4 fetchRow3d(ivec3 low, int highX, float f) {
  return mix(texelFetch(integrationTable3d, low, 0), texelFetch(integrationTable3d, ivec3(highX, low.yz), 0), f);
}

vec4 sampleTable3d(vec3 at) {
  const ivec3 size = textureSize(integrationTable3d, 0);
  const vec3 texel = clamp(at, 0.0, 1.0) * vec3(size - 1);
  if (!kTableFetch) return textureLod(integrationTable3d, (texel + 0.5) / vec3(size), 0.0);
  const ivec3 low = min(ivec3(texel), max(size - 2, ivec3(0)));
  const ivec3 high = min(low + 1, size - 1);
  const vec3 f = texel - vec3(low);
  return mix(mix(fetchRow3d(low, high.x, f.x), fetchRow3d(ivec3(low.x, high.y, low.z), high.x, f.x), f.y),
             mix(fetchRow3d(ivec3(low.xy, high.z), high.x, f.x), fetchRow3d(ivec3(low.x, high.yz), high.x, f.x), f.y),
             f.z);
}
