// Bitonic sort: the exchanges over one stride that is too long for a block, one per invocation.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

#define BITONIC_PAIRS_IN 0
#define BITONIC_PAIRS 1
#include "include/bitonic.glsl"
#include "include/bitonic_pairs.glsl"
#include "include/dispatch.glsl"

layout(push_constant, scalar) uniform Push {
  PairsAt pairsAt;
  uint cellCount;
  uint stride;
  uint isMirrored;  // first stride of its level
};

void main() {
  const uint low = lowerPlace(linearIndex(), stride);
  const uint high = higherPlace(low, stride, isMirrored != 0u);
  if (high >= cellCount) return;
  const uvec2 a = loadPair(pairsAt, low);
  const uvec2 b = loadPair(pairsAt, high);
  const bool isKept = isBefore(a, b);
  storePair(pairsAt, low, isKept ? a : b);
  storePair(pairsAt, high, isKept ? b : a);
}
