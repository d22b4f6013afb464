// Visibility order, first step: how many cells each cell has to wait for, and which wait for it.
//
// One invocation per cell that the cull pass kept or found transparent: rays pass through transparent cells, and with
// them the order of what lies on either side.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "shared/frame_view.h"
#include "shared/limits.h"
#include "shared/clipped_cells.h"
#include "shared/spec_ids.h"
#include "shared/visibility.h"

layout(local_size_x = 64) in;

#define MESH_CELLS 1
#define MESH_VERTICES 2
#define MESH_CELL_SCALARS 3
#define TOPOLOGY_NEIGHBORS 4
#define TOPOLOGY_SIDES 5
#include "include/dispatch.glsl"
#include "include/mesh_access.glsl"
#include "include/view_space.glsl"
#include "include/face_order.glsl"

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
layout(binding = 6) uniform usamplerBuffer keys;
layout(binding = 7, scalar) writeonly buffer Waiting { uint waiting[]; };
layout(binding = 8, scalar) buffer Status { PeelStatus status; };

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer UintsAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  TopologyAddresses topology;
  UintsAt keysAt;
  UintsAt waitingAt;
};

uint loadKey(uint cell) { return kWideAddressing ? keysAt.data[cell] : texelFetch(keys, int(cell)).x; }

void main() {
  const uint cellIndex = linearIndex();
  if (cellIndex >= view.cellCount) return;
  const bool isPresent = loadKey(cellIndex) != KEY_OUTSIDE;
  uint state = WAIT_ABSENT;
  if (isPresent) {
    const Cell cell = loadCell(mesh, cellIndex);
    const FaceOrder order = faceOrder(view, cell, loadSides(topology, cellIndex));
    const uvec4 neighbors = loadNeighbors(topology, cellIndex);
    uint front = 0;
    uint count = 0;
    for (int k = 0; k < 4; k++) {
      const bool isThere = neighbors[k] != NO_CELL && loadKey(min(neighbors[k], view.cellCount - 1u)) != KEY_OUTSIDE;
      if (isThere && order.inFront[k]) front |= 1u << k;
      if (isThere && order.behind[k]) count++;
    }
    state = count | front << WAIT_FRONT_SHIFT;
    if (order.isEyeInside) status.eyeInside = 1u;
  }
  if (kWideAddressing)
    waitingAt.data[cellIndex] = state;
  else
    waiting[cellIndex] = state;
  const uint present = subgroupBallotBitCount(subgroupBallot(isPresent));
  if (subgroupElect()) atomicAdd(status.present, present);
}
