// Radix sort, chunked variant, second step: the counts of every digit become offsets of its chunks, the totals become
// beginnings of the digits, and their sum is the number of keys.
//
// One workgroup, one invocation per digit: there are few chunks.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"

layout(local_size_x = 256) in;

layout(binding = 0, scalar) buffer Counts { uint counts[]; };            // [digit][chunk]
layout(binding = 1, scalar) writeonly buffer Totals { uint totals[]; };  // [digit]: beginnings
layout(binding = 2, scalar) writeonly buffer Kept { uint kept; };

layout(push_constant, scalar) uniform Push { uint chunkCount; };

shared uint digitTotals[SORT_DIGITS];

void main() {
  const uint digit = gl_LocalInvocationIndex;
  uint sum = 0;
  for (uint chunk = 0; chunk < chunkCount; chunk++) {
    const uint count = counts[digit * chunkCount + chunk];
    counts[digit * chunkCount + chunk] = sum;
    sum += count;
  }
  digitTotals[digit] = sum;
  barrier();
  uint before = 0;
  for (uint i = 0; i < digit; i++) before += digitTotals[i];
  totals[digit] = before;
  if (digit == SORT_DIGITS - 1u) kept = before + sum;
}
