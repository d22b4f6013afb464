// Radix sort, chunked variant, first step: how many keys of each run have each digit.
//
// For devices whose invocations are cheap loops on a processor: one invocation goes through a long run of keys by itself.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/sort.h"
#include "shared/spec_ids.h"

layout(local_size_x = 16) in;

#define SORT_KEYS_IN 0
#include "include/dispatch.glsl"
#include "include/sort_keys.glsl"

layout(binding = 1, scalar) writeonly buffer Counts { uint counts[]; };  // [digit][chunk]
layout(binding = 2, scalar) readonly buffer Kept { uint kept; };

layout(push_constant, scalar) uniform Push {
  UintsAt keysAt;
  uint cellCount;
  uint chunkCount;
  uint shift;
};

shared uint counters[SORT_DIGITS * SORT_CHUNK_THREADS];  // [digit][thread]

void main() {
  const uint chunk = linearIndex();
  const uint thread = gl_LocalInvocationIndex;
  for (uint digit = 0; digit < SORT_DIGITS; digit++) counters[digit * SORT_CHUNK_THREADS + thread] = 0u;
  const uint count = elementCount(cellCount, kept);
  const uint length = (count + chunkCount - 1u) / chunkCount;
  const uint first = min(chunk * length, count);
  const uint last = min(first + length, count);
  for (uint i = first; i < last; i++) {
    const uint key = loadKey(keysAt, i);
    if (takesPart(key)) counters[digitOf(key, shift) * SORT_CHUNK_THREADS + thread]++;
  }
  if (chunk >= chunkCount) return;
  for (uint digit = 0; digit < SORT_DIGITS; digit++)
    counts[digit * chunkCount + chunk] = counters[digit * SORT_CHUNK_THREADS + thread];
}
