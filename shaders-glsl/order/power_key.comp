// Sort keys from the power of the eye with respect to every cell's circumsphere (power distance), farthest first.
//
// The power |e - c|^2 - r^2 orders the cells of a Delaunay mesh, and of any part of one, exactly (Edelsbrunner 1990). It is
// evaluated relative to |e|^2 and to a vertex v of the cell, with c' = c - v computed in double precision at load:
//
//     |e - c|^2 - r^2 - |e|^2  =  v . (v - 2 e) + 2 c' . (v - e)
//
// so that digits are lost neither to a far eye nor to the large circumspheres of slivers. Orthographic limit, divided by
// -2 |e|: the depth of the circumcentre.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/frame_view.h"
#include "shared/limits.h"
#include "shared/clipped_cells.h"
#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

#define MESH_CELLS 1
#define MESH_VERTICES 2
#define MESH_CELL_SCALARS 3
#include "include/dispatch.glsl"
#include "include/mesh_access.glsl"
#include "include/view_space.glsl"

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
layout(binding = 4) uniform samplerBuffer circumcenters;  // relative to the cell's first vertex, mesh space
layout(binding = 5, scalar) buffer Keys { uint keys[]; };

layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer CircumcentersAt { vec4 data[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer UintsAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  CircumcentersAt circumcentersAt;
  UintsAt keysAt;
};

// Order-preserving map from floats to 31 bits: the lowest bit of the significand is given up for the sign.
uint orderedBits(float value) {
  const uint bits = floatBitsToUint(value);
  return (((bits >> 31) != 0u) ? ~bits : bits | 0x80000000u) >> 1;
}

void main() {
  const uint cellIndex = linearIndex();
  if (cellIndex >= view.cellCount) return;
  const uint key = kWideAddressing ? keysAt.data[cellIndex] : keys[cellIndex];
  if (key == KEY_OUTSIDE) return;
  const vec3 v = loadCell(mesh, cellIndex).position[0];
  const vec3 c = (kWideAddressing ? circumcentersAt.data[cellIndex] : texelFetch(circumcenters, int(cellIndex))).xyz;
  const vec3 e = view.eyeMesh.xyz;
  const float power = kPerspective ? dot(v, v - 2.0 * e) + 2.0 * dot(c, v - e) : dot(view.viewFromMesh[2].xyz, v + c);
  const uint newKey = (0x7fffffffu - orderedBits(power)) | (key & KEY_TRANSPARENT);
  if (kWideAddressing)
    keysAt.data[cellIndex] = newKey;
  else
    keys[cellIndex] = newKey;
}
