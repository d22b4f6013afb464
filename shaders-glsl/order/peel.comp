// Visibility order, third step: level after level, cells that have nothing left behind them (Kahn 1962).
//
// One workgroup does it all, because a level is too small to be worth a dispatch. A cell's level is the length of the longest
// chain of cells behind it, whatever order threads come in: levels, used as sort keys, give the same picture every time.
// What is still waiting in the end is part of a cycle, or in front of one.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"
#include "shared/visibility.h"

layout(local_size_x = 256) in;

layout(constant_id = SPEC_WIDE_ADDRESSING) const bool kWideAddressing = false;
layout(constant_id = SPEC_RELATIONS) const bool kRelations = false;

layout(binding = 0) uniform usamplerBuffer topologyNeighbors;
layout(binding = 1, scalar) coherent buffer Waiting { uint waiting[]; };
layout(binding = 2, scalar) coherent buffer Queue { uint queue[]; };
layout(binding = 3, scalar) buffer Keys { uint keys[]; };
layout(binding = 4, scalar) buffer Status { PeelStatus status; };
layout(binding = 5, scalar) readonly buffer RelationHeads { uint relationHeads[]; };
layout(binding = 6, scalar) readonly buffer Relations { Relation relations[]; };

layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer NeighborsAt { uvec4 data[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) coherent buffer UintsAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  NeighborsAt neighborsAt;
  UintsAt waitingAt;
  UintsAt queueAt;
  UintsAt keysAt;
  UintsAt relationHeadsAt;
};

shared uint queueEnd;

void release(uint cell) {
  const uint before = kWideAddressing ? atomicAdd(waitingAt.data[cell], 0xffffffffu) : atomicAdd(waiting[cell], 0xffffffffu);
  if ((before & WAIT_COUNT) == 1u) {
    const uint place = atomicAdd(queueEnd, 1u);
    if (kWideAddressing)
      queueAt.data[place] = cell;
    else
      queue[place] = cell;
  }
}

void peel(uint cell, uint level) {
  const uint state = kWideAddressing ? waitingAt.data[cell] : waiting[cell];
  const uint key = kWideAddressing ? keysAt.data[cell] : keys[cell];
  const uint newKey = level | (key & KEY_TRANSPARENT);
  if (kWideAddressing) {
    waitingAt.data[cell] = state | WAIT_PEELED;
    keysAt.data[cell] = newKey;
  } else {
    waiting[cell] = state | WAIT_PEELED;
    keys[cell] = newKey;
  }
  const uvec4 neighbors = kWideAddressing ? neighborsAt.data[cell] : texelFetch(topologyNeighbors, int(cell));
  for (uint k = 0; k < 4u; k++) {
    if (((state >> (WAIT_FRONT_SHIFT + k)) & 1u) != 0u) release(neighbors[k]);
  }
  if (kRelations && (state & WAIT_RELATED) != 0u) {
    uint node = kWideAddressing ? relationHeadsAt.data[cell] : relationHeads[cell];
    for (uint i = 0; i < 65535u; i++) {
      if (node == NO_NODE) break;
      release(relations[node].cell);
      node = relations[node].next;
    }
  }
}

void main() {
  uint begin = status.begin;
  uint end = status.end;
  uint level = status.level;
  if (gl_LocalInvocationIndex == 0u) queueEnd = end;
  barrier();
  // Mesa's software device ends every loop after 65535 rounds; the host calls again while there is something left.
  for (uint round = 0; round < 60000u; round++) {
    if (begin == end) break;
    for (uint i = begin + gl_LocalInvocationIndex; i < end; i += gl_WorkGroupSize.x)
      peel(kWideAddressing ? queueAt.data[i] : queue[i], level);
    memoryBarrierBuffer();
    barrier();
    begin = end;
    end = queueEnd;
    level++;
    barrier();
  }
  if (gl_LocalInvocationIndex == 0u) {
    status.begin = begin;
    status.end = end;
    status.level = level;
  }
}
