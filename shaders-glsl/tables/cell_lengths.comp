// The longest edge, the volume and the surface of the mesh's cells, in parts: an invocation adds up every
// `invocations`-th cell.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

#define MESH_CELLS 0
#define MESH_VERTICES 1
#define MESH_CELL_SCALARS 2
#include "include/dispatch.glsl"
#include "include/mesh_access.glsl"

layout(binding = 3, scalar) writeonly buffer Parts { vec4 parts[]; };  // x longest edge, y volume, z surface; mesh units

layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  uint cellCount;
  uint invocations;
};

void main() {
  const uint first = linearIndex();
  if (first >= invocations) return;
  float longest = 0.0;
  float volume = 0.0;
  float surface = 0.0;
  for (uint cell = first; cell < cellCount; cell += invocations) {
    const Cell c = loadCell(mesh, cell);
    const vec3 a = c.position[1] - c.position[0], b = c.position[2] - c.position[0], d = c.position[3] - c.position[0];
    const vec3 ab = b - a, ad = d - a, bd = d - b;
    const float squares = max(max(max(dot(a, a), dot(b, b)), dot(d, d)), max(max(dot(ab, ab), dot(ad, ad)), dot(bd, bd)));
    longest = max(longest, sqrt(squares));
    volume += abs(dot(a, cross(b, d))) * (1.0 / 6.0);
    surface += 0.5 * (length(cross(a, b)) + length(cross(a, d)) + length(cross(b, d)) + length(cross(ab, ad)));
  }
  parts[first] = vec4(longest, volume, surface, 0.0);
}
