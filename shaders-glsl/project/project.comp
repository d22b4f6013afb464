// Cells to what is drawn of them (include/project_cell.glsl): one invocation per cell of a batch, in drawing order.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "shared/batch_arguments.h"
#include "shared/counters.h"
#include "shared/frame_view.h"
#include "shared/limits.h"
#include "shared/clipped_cells.h"
#include "shared/spec_ids.h"
#include "shared/truth_table.h"

layout(local_size_x = 64) in;

#define MESH_CELLS 1
#define MESH_VERTICES 2
#define MESH_CELL_SCALARS 3
#include "include/dispatch.glsl"
#include "include/mesh_access.glsl"
#include "include/view_space.glsl"

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
#define TRUTH_TABLE 4
#define LARGEST_EXTINCTIONS 10
#include "include/project_cell.glsl"
layout(binding = 5) uniform usamplerBuffer order;                               // cell indices, farthest first
layout(binding = 6, scalar) buffer Counters { FrameCounters counters; };
layout(binding = 7, scalar) writeonly buffer Positions { vec2 positions[]; };   // ndc, FAN_VERTICES per cell
layout(binding = 8, scalar) writeonly buffer Ends { vec4 ends[]; }; // FAN_VERTICES per cell
layout(binding = 9, scalar) writeonly buffer CellModes { uint cellModes[]; };   // 1: clipped cell, 0: fan

layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer OrderAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  OrderAt orderAt;
  uint firstSlot;  // of this batch
  uint endSlot;    // behind its last one, an upper bound; the sort's result says how many there are
  uint isCounted;  // 0: the batch was projected before in this frame
};

void main() {
  const uint slot = linearIndex();
  const uint globalSlot = firstSlot + slot;
  if (slot >= BATCH_CELLS || globalSlot >= min(counters.drawn, endSlot)) return;
  const uint cellIndex = kWideAddressing ? orderAt.data[globalSlot] : texelFetch(order, int(globalSlot)).x;
  const Fan fan = drawnCell(loadCell(mesh, cellIndex));
  for (uint i = 0; i < FAN_VERTICES; i++) {
    positions[slot * FAN_VERTICES + i] = fan.position[i];
    ends[slot * FAN_VERTICES + i] = fan.ends[i];
  }
  cellModes[slot] = fan.isClipped ? 1u : 0u;

  const uint triangles = subgroupAdd(fan.triangles);
  const uint clipped = subgroupAdd(fan.isClipped ? 1u : 0u);
  if (subgroupElect() && isCounted != 0u) {
    atomicAdd(counters.triangles, triangles);
    if (clipped > 0) atomicAdd(counters.clipped, clipped);
  }
}
