// Arguments of the project and raster passes of every batch, from the number of cells that the sort kept.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/batch_arguments.h"
#include "shared/counters.h"
#include "shared/limits.h"

layout(local_size_x = 64) in;

#include "include/dispatch.glsl"

layout(binding = 0, scalar) readonly buffer Kept { uint kept; };
layout(binding = 1, scalar) buffer Counters { FrameCounters counters; };
layout(binding = 2, scalar) writeonly buffer Arguments { BatchArguments arguments[]; };

layout(push_constant, scalar) uniform Push { uint batchCount; };

void main() {
  const uint batch = linearIndex();
  if (batch >= batchCount) return;
  const uint first = batch * BATCH_CELLS;
  const uint count = kept > first ? min(kept - first, BATCH_CELLS) : 0u;
  arguments[batch].groupsX = (count + PROJECT_WORKGROUP - 1u) / PROJECT_WORKGROUP;
  arguments[batch].groupsY = 1u;
  arguments[batch].groupsZ = 1u;
  arguments[batch].indexCount = count * FAN_INDICES;
  arguments[batch].instanceCount = count > 0u ? 1u : 0u;
  arguments[batch].firstIndex = 0u;
  arguments[batch].vertexOffset = 0u;
  arguments[batch].firstInstance = 0u;
  if (batch == 0u) counters.drawn = kept;
}
