// Counts the shared faces whose two cells the sort keys put the wrong way round.
//
// One invocation per cell; a face is counted by its cell of lower index. Cells are drawn by ascending key, equal keys by
// ascending index. Faces of cells that no pixel's ray meets do not count.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_arithmetic : require

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
layout(binding = 7, scalar) buffer Count { OrderCount count; };

layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer UintsAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  TopologyAddresses topology;
  UintsAt keysAt;
  uint keyShift;  // lowest bit that the sort looks at
  uint tiesAreApart;  // cells of equal keys are composited apart, in the right order by themselves
};

uint loadKey(uint cell) { return kWideAddressing ? keysAt.data[cell] : texelFetch(keys, int(cell)).x; }

void main() {
  const uint cellIndex = linearIndex();
  if (cellIndex >= view.cellCount) return;
  const uint key = loadKey(cellIndex);
  uint faces = 0;
  uint misordered = 0;
  if (key != KEY_OUTSIDE) {
    const Cell cell = loadCell(mesh, cellIndex);
    const FaceOrder order = faceOrder(view, cell, loadSides(topology, cellIndex));
    if (order.isEyeInside) count.eyeInside = 1u;
    const uvec4 neighbors = loadNeighbors(topology, cellIndex);
    const uint rank = (key & ~KEY_TRANSPARENT) >> keyShift;
    for (int k = 0; k < 4; k++) {
      if (neighbors[k] == NO_CELL || neighbors[k] < cellIndex || !(order.inFront[k] || order.behind[k])) continue;
      const uint otherKey = loadKey(neighbors[k]);
      if (otherKey == KEY_OUTSIDE) continue;
      const uint otherRank = (otherKey & ~KEY_TRANSPARENT) >> keyShift;
      faces++;
      if (rank == otherRank && tiesAreApart != 0u) continue;
      const bool isDrawnFirst = rank <= otherRank;  // this cell has the lower index
      if (isDrawnFirst ? order.behind[k] : order.inFront[k]) misordered++;
    }
  }
  faces = subgroupAdd(faces);
  misordered = subgroupAdd(misordered);
  if (subgroupElect()) {
    atomicAdd(count.faces, faces);
    if (misordered > 0) atomicAdd(count.misordered, misordered);
  }
}
