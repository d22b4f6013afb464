// Radix sort, tiled variant, third step: where each digit begins, and how many keys there are.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"

layout(local_size_x = 1) in;

layout(binding = 0, scalar) buffer Totals { uint totals[]; };  // [digit]: totals become beginnings
layout(binding = 1, scalar) writeonly buffer Kept { uint kept; };

void main() {
  uint sum = 0;
  for (uint digit = 0; digit < SORT_DIGITS; digit++) {
    const uint total = totals[digit];
    totals[digit] = sum;
    sum += total;
  }
  kept = sum;
}
