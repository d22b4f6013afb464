// Keeps cells beside the ones that show: those between two of them. A ray that leaves what shows and comes back is several times
// dearer than the step through such a cell, and without these holes the surface around what shows has fewer faces. One invocation per
// cell.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/skip.h"
#include "shared/spec_ids.h"

layout(local_size_x = SKIP_WORKGROUP) in;

layout(constant_id = SPEC_WIDE_ADDRESSING) const bool kWideAddressing = false;

#include "include/dispatch.glsl"
#include "include/skip_topology.glsl"

layout(binding = 2, scalar) buffer Kept { uint kept[]; };  // a bit per cell

layout(push_constant, scalar) uniform Push {
  AcrossAt acrossAt;
  uint cellCount;
};

bool isKept(uint cell) {
  if (hasBit(cell)) return true;
  uint showing = 0;
  for (uint k = 0; k < 4u; k++) {
    const uint next = loadAcross(acrossAt, cell, k).x;
    if (next != NO_CELL && hasBit(min(next, cellCount - 1u))) showing++;
  }
  return showing >= 2u;
}

void main() {
  const uint cell = linearIndex();
  if (cell < cellCount && isKept(cell)) atomicOr(kept[cell / 32u], 1u << cell % 32u);
}
