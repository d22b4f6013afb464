// Bitonic sort: the end of a level, all strides that stay within a block.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/bitonic.h"
#include "shared/spec_ids.h"

layout(local_size_x = BITONIC_THREADS) in;

#define BITONIC_PAIRS_IN 0
#define BITONIC_PAIRS 1
#include "include/bitonic.glsl"
#include "include/bitonic_block.glsl"
#include "include/bitonic_pairs.glsl"
#include "include/dispatch.glsl"

layout(push_constant, scalar) uniform Push {
  PairsAt pairsAt;
  uint cellCount;
};

void main() {
  const uint first = workgroupIndex() * BITONIC_BLOCK;
  if (first >= cellCount) return;
  for (uint i = gl_LocalInvocationIndex; i < BITONIC_BLOCK; i += BITONIC_THREADS)
    block[i] = first + i < cellCount ? loadPair(pairsAt, min(first + i, cellCount - 1u)) : uvec2(0xffffffffu);
  barrier();
  for (uint stride = BITONIC_BLOCK / 2u; stride > 0u; stride /= 2u) exchangeInBlock(stride, false);
  for (uint i = gl_LocalInvocationIndex; i < BITONIC_BLOCK; i += BITONIC_THREADS) {
    if (first + i >= cellCount) break;
    storePair(pairsAt, first + i, block[i]);
  }
}
