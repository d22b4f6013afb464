// Power keys, second step: neighbours with the same number are to be drawn by their level, the length of the longest chain of
// such neighbours behind a cell. A step makes the levels right that are at most one more than those it finds, so
// POWER_LEVELS - 1 steps make all right, up to the last level, which may be too low; whatever order invocations come in.
//
// One invocation per cell, which writes its own key. Which of two cells is nearer is asked of the face itself. In a Delaunay mesh
// of random points one face in a million needs this, alone or in threes about an edge; in a regular grid every cell, six or
// five to a cube, and four levels are enough.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/clipped_cells.h"
#include "shared/frame_view.h"
#include "shared/limits.h"
#include "shared/power_keys.h"
#include "shared/spec_ids.h"

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
layout(binding = 6) uniform usamplerBuffer keysIn;  // the same buffer as:
layout(binding = 7, scalar) writeonly buffer Keys { uint keys[]; };

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer UintsAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  TopologyAddresses topology;
  UintsAt keysAt;
};

uint loadKey(uint cell) { return kWideAddressing ? keysAt.data[cell] : texelFetch(keysIn, int(cell)).x; }

uint numberOf(uint key) { return (key & ~KEY_TRANSPARENT) >> POWER_LEVEL_BITS; }

void main() {
  const uint cellIndex = linearIndex();
  if (cellIndex >= view.cellCount) return;
  const uint key = loadKey(cellIndex);
  if (key == KEY_OUTSIDE) return;
  const uvec4 neighbors = loadNeighbors(topology, cellIndex);
  uvec4 levelIfBehind = uvec4(0);  // that a tied neighbour asks for, when it is behind
  for (int k = 0; k < 4; k++) {
    const uint neighborKey = neighbors[k] == NO_CELL ? KEY_OUTSIDE : loadKey(min(neighbors[k], view.cellCount - 1u));
    if (neighborKey != KEY_OUTSIDE && numberOf(neighborKey) == numberOf(key))
      levelIfBehind[k] = min(neighborKey % POWER_LEVELS + 1u, POWER_LEVELS - 1u);
  }
  if (all(equal(levelIfBehind, uvec4(0)))) return;
  const FaceOrder order = faceOrder(view, loadCell(mesh, cellIndex), loadSides(topology, cellIndex));
  uint level = 0;
  for (int k = 0; k < 4; k++) {
    if (order.behind[k] && !order.inFront[k]) level = max(level, levelIfBehind[k]);
  }
  const uint newKey = key - key % POWER_LEVELS + level;
  if (kWideAddressing)
    keysAt.data[cellIndex] = newKey;
  else
    keys[cellIndex] = newKey;
}
