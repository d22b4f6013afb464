// Arguments of the project and raster passes of a batch, from the number of cells that the sort kept.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/batch_arguments.h"
#include "shared/counters.h"
#include "shared/limits.h"
#include "shared/spec_ids.h"

layout(local_size_x = 1) in;

layout(constant_id = SPEC_SILHOUETTE) const bool kSilhouette = false;

layout(binding = 0, scalar) readonly buffer Kept { uint kept; };
layout(binding = 1, scalar) buffer Counters { FrameCounters counters; };
layout(binding = 2, scalar) writeonly buffer Arguments { BatchArguments arguments; };

layout(push_constant, scalar) uniform Push {
  uint first;  // slot
  uint end;    // slot behind the last, or more than there are
};

void main() {
  const uint count = kept > first ? min(kept, end) - first : 0u;
  arguments.groupsX = (count + PROJECT_WORKGROUP - 1u) / PROJECT_WORKGROUP;
  arguments.groupsY = 1u;
  arguments.groupsZ = 1u;
  arguments.indexCount = count * (kSilhouette ? OUTLINE_INDICES : FAN_INDICES);
  arguments.instanceCount = count > 0u ? 1u : 0u;
  arguments.firstIndex = 0u;
  arguments.vertexOffset = 0u;
  arguments.firstInstance = 0u;
  counters.drawn = kept;
}
