// Radix sort, tiled variant, second step: the counts of one digit become offsets of its tiles, and a total.
//
// One workgroup per digit; exclusive prefix sum over a row of any length.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "shared/limits.h"

layout(local_size_x = 256) in;

layout(binding = 0, scalar) buffer Counts { uint counts[]; };            // [digit][column]
layout(binding = 1, scalar) writeonly buffer Totals { uint totals[]; };  // [digit]

layout(push_constant, scalar) uniform Push { uint columnCount; };

shared uint subgroupSums[256];

// Exclusive prefix sum over the workgroup; `sum` is the whole.
uint scanWorkgroup(uint value, out uint sum) {
  const uint inclusive = subgroupInclusiveAdd(value);
  if (gl_SubgroupInvocationID == gl_SubgroupSize - 1u) subgroupSums[gl_SubgroupID] = inclusive;
  barrier();
  uint before = 0;
  sum = 0;
  for (uint i = 0; i < gl_NumSubgroups; i++) {
    before += i < gl_SubgroupID ? subgroupSums[i] : 0u;
    sum += subgroupSums[i];
  }
  barrier();
  return before + inclusive - value;
}

void main() {
  const uint digit = gl_WorkGroupID.x;
  uint carried = 0;
  for (uint start = 0; start < columnCount; start += gl_WorkGroupSize.x) {
    const uint column = start + gl_LocalInvocationIndex;
    const uint value = column < columnCount ? counts[digit * columnCount + column] : 0u;
    uint sum;
    const uint offset = carried + scanWorkgroup(value, sum);
    if (column < columnCount) counts[digit * columnCount + column] = offset;
    carried += sum;
  }
  if (gl_LocalInvocationIndex == 0u) totals[digit] = carried;
}
