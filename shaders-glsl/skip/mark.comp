// Marks the cells that show: those with extinction or emission anywhere in their scalar range. One invocation per cell.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/skip.h"
#include "shared/spec_ids.h"

layout(local_size_x = SKIP_WORKGROUP) in;

#define MESH_CELLS 0
#define MESH_VERTICES 1
#define MESH_CELL_SCALARS 2
#define SUPPORT_INTERVALS 3
#include "include/dispatch.glsl"
#include "include/mesh_access.glsl"
#include "include/support.glsl"

layout(binding = 4, scalar) buffer Shows { uint shows[]; };  // a bit per cell

layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  uint cellCount;
  uint supportCount;
};

bool showsAnything(uint cell) {
  const uvec4 vertices = loadCellVertices(mesh, cell);
  // A cell with a vertex that it has twice is nowhere (Adjacency::boundary).
  if (any(greaterThanEqual(vertices.xyz, vertices.yzw))) return false;
  float low;
  float high;
  if (kCellField) {
    low = high = loadCellScalar(mesh, cell);
  } else {
    low = high = loadVertex(mesh, vertices.x).w;
    for (int i = 1; i < 4; i++) {
      const float scalar = loadVertex(mesh, vertices[i]).w;
      low = min(low, scalar);
      high = max(high, scalar);
    }
  }
  return isInSupport(low, high, supportCount);
}

void main() {
  const uint cell = linearIndex();
  if (cell < cellCount && showsAnything(cell)) atomicOr(shows[cell / 32u], 1u << cell % 32u);
}
