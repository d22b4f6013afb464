// The table behind include/integration/opacity2d.glsl: opacity over extinction and thickness (Stein, Becker and Max 1994).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/integration.h"
#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

#define TABLE_WORDS 0
#include "include/dispatch.glsl"
#include "include/table_store.glsl"
#include "include/integration/segment_functions.glsl"

layout(push_constant, scalar) uniform Push { TableParameters table; };

void main() {
  const uint index = linearIndex();
  if (4u * index >= table.width * table.height) return;
  vec4 value;
  for (uint i = 0; i < 4u; i++) {
    const uint texel = 4u * index + i;
    const vec2 at = vec2(texel % table.width, texel / table.width) / vec2(table.width - 1u, table.height - 1u);
    value[i] = oneMinusExp(at.x * table.largestExtinction * (at.y * table.thickness));
  }
  storeFour(index, value);
}
