// Packs entries of four 32-bit floats into a table's format.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/integration.h"
#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

#define TABLE_WORDS 0
#include "include/dispatch.glsl"
#include "include/table_store.glsl"

layout(binding = 1) uniform samplerBuffer entries;

layout(push_constant, scalar) uniform Push { TableParameters table; };

void main() {
  const uint index = linearIndex();
  if (index >= table.width * table.height * table.depth) return;
  storeFour(index, texelFetch(entries, int(index)) / vec4(vec3(table.lightPerValue), table.opacityPerValue));
}
