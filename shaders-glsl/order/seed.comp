// Visibility order, second step: cells with nothing behind them are the first level.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "shared/spec_ids.h"
#include "shared/visibility.h"

layout(local_size_x = 64) in;

layout(constant_id = SPEC_WIDE_ADDRESSING) const bool kWideAddressing = false;

#include "include/dispatch.glsl"

layout(binding = 0) uniform usamplerBuffer waiting;
layout(binding = 1, scalar) writeonly buffer Queue { uint queue[]; };
layout(binding = 2, scalar) buffer Status { PeelStatus status; };

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer UintsAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  UintsAt waitingAt;
  UintsAt queueAt;
  uint cellCount;
};

void main() {
  const uint cell = linearIndex();
  const uint state = cell >= cellCount ? WAIT_ABSENT : kWideAddressing ? waitingAt.data[cell] : texelFetch(waiting, int(cell)).x;
  const bool isReady = state != WAIT_ABSENT && (state & WAIT_COUNT) == 0u;
  const uvec4 ready = subgroupBallot(isReady);
  uint place = 0;
  if (subgroupElect() && any(notEqual(ready, uvec4(0)))) place = atomicAdd(status.end, subgroupBallotBitCount(ready));
  place = subgroupBroadcastFirst(place) + subgroupBallotExclusiveBitCount(ready);
  if (!isReady) return;
  if (kWideAddressing)
    queueAt.data[place] = cell;
  else
    queue[place] = cell;
}
