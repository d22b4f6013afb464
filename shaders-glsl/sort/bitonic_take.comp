// Bitonic sort, last step: the cells of the sorted pairs. Those beyond the kept ones are not drawn.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

layout(constant_id = SPEC_WIDE_ADDRESSING) const bool kWideAddressing = false;

#include "include/dispatch.glsl"

layout(binding = 0) uniform usamplerBuffer pairs;
layout(binding = 1, scalar) writeonly buffer Order { uint order[]; };

layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer PairsAt { uvec2 data[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) writeonly buffer OrderAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  PairsAt pairsAt;
  OrderAt orderAt;
  uint cellCount;
};

void main() {
  const uint i = linearIndex();
  if (i >= cellCount) return;
  if (kWideAddressing)
    orderAt.data[i] = pairsAt.data[i].y;
  else
    order[i] = texelFetch(pairs, int(i)).y;
}
