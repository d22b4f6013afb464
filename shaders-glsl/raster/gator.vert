// One vertex of a cell, projected by the vertex shader itself (Wylie, Moreland, Fisk and Crossno 2002). They gave every vertex all
// four of the cell's and found its place in a graph that is the same for every cell, whatever its class; here that graph is the fan,
// and a vertex takes its own corner of the projection. All five of a cell repeat the same work, but nothing is stored between
// passes.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/clipped_cells.h"
#include "shared/frame_view.h"
#include "shared/limits.h"
#include "shared/cell_push.h"
#include "shared/spec_ids.h"
#include "shared/truth_table.h"

#define MESH_CELLS 1
#define MESH_VERTICES 2
#define MESH_CELL_SCALARS 3
#include "include/mesh_access.glsl"
#include "include/view_space.glsl"

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
#define TRUTH_TABLE 4
#define LARGEST_EXTINCTIONS 6
#include "include/project_cell.glsl"
layout(binding = 5) uniform usamplerBuffer order;  // cell indices, farthest first

layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer OrderAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  CellPush push;
  MeshAddresses mesh;
  OrderAt orderAt;
};

#define TRANSFER_PIECES 7
#define TRANSFER_PIECE_BINS 8
#include "include/fan_vertex.glsl"

layout(location = 3) flat out vec4 flatPlanes[FAN_VERTICES];

void main() {
  const int slot = gl_VertexIndex / int(FAN_VERTICES);
  const int corner = gl_VertexIndex % int(FAN_VERTICES);
  const uint globalSlot = push.firstSlot + uint(slot);
  const uint cell = kWideAddressing ? orderAt.data[globalSlot] : texelFetch(order, int(globalSlot)).x;
  const Fan fan = drawnCell(loadCell(mesh, cell));
  handOnVertex(fan.position[corner], fan.ends[corner], slot, fan.isClipped);
  flatPlanes = fan.ends;
}
