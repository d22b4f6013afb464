// Radix sort, tiled variant, first step: how many keys of each tile have each digit.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/sort.h"
#include "shared/spec_ids.h"

layout(local_size_x = 256) in;

#define SORT_KEYS_IN 0
#include "include/dispatch.glsl"
#include "include/sort_keys.glsl"

layout(binding = 1, scalar) writeonly buffer Counts { uint counts[]; };  // [digit][tile]
layout(binding = 2, scalar) readonly buffer Kept { uint kept; };

layout(push_constant, scalar) uniform Push {
  UintsAt keysAt;
  uint cellCount;
  uint tileCount;
  uint shift;
};

shared uint tileCounts[SORT_DIGITS];

void main() {
  const uint tile = workgroupIndex();
  const uint thread = gl_LocalInvocationIndex;
  tileCounts[thread] = 0;
  barrier();
  const uint count = elementCount(cellCount, kept);
  for (uint k = 0; k < SORT_TILE_KEYS_PER_THREAD; k++) {
    const uint i = tile * SORT_TILE_KEYS + k * SORT_TILE_THREADS + thread;
    if (i < count) {
      const uint key = loadKey(keysAt, i);
      if (takesPart(key)) atomicAdd(tileCounts[digitOf(key, shift)], 1u);
    }
  }
  barrier();
  if (tile < tileCount) counts[thread * tileCount + tile] = tileCounts[thread];
}
