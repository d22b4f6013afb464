// Cells that overlap hide each other: each waits for the other, and both are found in a cycle.
//
// One invocation per pair.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"
#include "shared/visibility.h"

layout(local_size_x = 64) in;

layout(constant_id = SPEC_WIDE_ADDRESSING) const bool kWideAddressing = false;

#include "include/dispatch.glsl"

layout(binding = 0) uniform usamplerBuffer overlaps;  // xy: a pair
layout(binding = 1) uniform usamplerBuffer keys;
layout(binding = 2, scalar) coherent buffer Waiting { uint waiting[]; };
layout(binding = 3, scalar) coherent buffer RelationHeads { uint relationHeads[]; };
layout(binding = 4, scalar) coherent buffer Relations { Relation relations[]; };
layout(binding = 5, scalar) buffer Status { PeelStatus status; };

layout(buffer_reference, scalar, buffer_reference_align = 4) coherent buffer UintsAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  UintsAt waitingAt;
  UintsAt relationHeadsAt;
  UintsAt keysAt;
  uint relationCapacity;
  uint pairCount;
};

#include "include/relations.glsl"

bool isPresent(uint cell) {
  return (kWideAddressing ? keysAt.data[cell] : texelFetch(keys, int(cell)).x) != KEY_OUTSIDE;
}

void main() {
  const uint index = linearIndex();
  if (index >= pairCount) return;
  const uvec2 pair = texelFetch(overlaps, int(index)).xy;
  if (!isPresent(pair.x) || !isPresent(pair.y)) return;
  addRelation(pair.x, pair.y);
  addRelation(pair.y, pair.x);
}
