// Bitonic sort, first step: keys become pairs, sorted within blocks, and the kept ones are counted.
//
// Cells that are not drawn take part with the last of all keys.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "shared/bitonic.h"
#include "shared/limits.h"
#include "shared/spec_ids.h"

layout(local_size_x = BITONIC_THREADS) in;

layout(constant_id = SPEC_WIDE_ADDRESSING) const bool kWideAddressing = false;

#include "include/bitonic.glsl"
#include "include/bitonic_block.glsl"
#include "include/dispatch.glsl"

layout(binding = 0) uniform usamplerBuffer keys;
layout(binding = 1, scalar) writeonly buffer Pairs { uvec2 pairs[]; };
layout(binding = 2, scalar) buffer Kept { uint kept; };

layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer KeysAt { uint data[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) writeonly buffer PairsAt { uvec2 data[]; };
layout(push_constant, scalar) uniform Push {
  KeysAt keysAt;
  PairsAt pairsAt;
  uint cellCount;
};

const uint kLastKey = 0xffffffffu;

uint loadKey(uint cell) {
  const uint key = kWideAddressing ? keysAt.data[cell] : texelFetch(keys, int(cell)).x;
  return key < KEY_TRANSPARENT ? key : kLastKey;
}

void main() {
  const uint first = workgroupIndex() * BITONIC_BLOCK;
  if (first >= cellCount) return;
  uint keptHere = 0;
  for (uint i = gl_LocalInvocationIndex; i < BITONIC_BLOCK; i += BITONIC_THREADS) {
    const uint cell = first + i;
    const uint key = cell < cellCount ? loadKey(min(cell, cellCount - 1u)) : kLastKey;
    block[i] = uvec2(key, cell);
    keptHere += subgroupBallotBitCount(subgroupBallot(key != kLastKey));
  }
  if (subgroupElect() && keptHere > 0u) atomicAdd(kept, keptHere);
  barrier();
  for (uint size = 2u; size <= BITONIC_BLOCK; size *= 2u) {
    exchangeInBlock(size / 2u, true);
    for (uint stride = size / 4u; stride > 0u; stride /= 2u) exchangeInBlock(stride, false);
  }
  for (uint i = gl_LocalInvocationIndex; i < BITONIC_BLOCK; i += BITONIC_THREADS) {
    if (first + i >= cellCount) break;
    if (kWideAddressing)
      pairsAt.data[first + i] = block[i];
    else
      pairs[first + i] = block[i];
  }
}
