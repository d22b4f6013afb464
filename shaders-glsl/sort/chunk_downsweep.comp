// Radix sort, chunked variant, last step: every key of a run to its place, in order.
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

layout(binding = 1) uniform usamplerBuffer valuesIn;
layout(binding = 2, scalar) readonly buffer Offsets { uint offsets[]; };  // [digit][chunk]
layout(binding = 3, scalar) readonly buffer Bases { uint bases[]; };      // [digit]
layout(binding = 4, scalar) readonly buffer Kept { uint kept; };
layout(binding = 5, scalar) writeonly buffer KeysOut { uint keysOut[]; };
layout(binding = 6, scalar) writeonly buffer ValuesOut { uint valuesOut[]; };

layout(push_constant, scalar) uniform Push {
  UintsAt keysAt;
  UintsAt valuesAt;
  UintsAt keysOutAt;
  UintsAt valuesOutAt;
  uint cellCount;
  uint chunkCount;
  uint shift;
};

shared uint places[SORT_DIGITS * SORT_CHUNK_THREADS];  // [digit][thread]

void main() {
  const uint chunk = linearIndex();
  const uint thread = gl_LocalInvocationIndex;
  if (chunk >= chunkCount) return;
  for (uint digit = 0; digit < SORT_DIGITS; digit++)
    places[digit * SORT_CHUNK_THREADS + thread] = bases[digit] + offsets[digit * chunkCount + chunk];
  const uint count = elementCount(cellCount, kept);
  const uint length = (count + chunkCount - 1u) / chunkCount;
  const uint first = min(chunk * length, count);
  const uint last = min(first + length, count);
  for (uint i = first; i < last; i++) {
    const uint key = loadKey(keysAt, i);
    if (!takesPart(key)) continue;
    const uint value = kFirstDigit ? i : kWideAddressing ? valuesAt.data[i] : texelFetch(valuesIn, int(i)).x;
    const uint place = places[digitOf(key, shift) * SORT_CHUNK_THREADS + thread]++;
    if (kWideAddressing) {
      keysOutAt.data[place] = key;
      valuesOutAt.data[place] = value;
    } else {
      keysOut[place] = key;
      valuesOut[place] = value;
    }
  }
}
