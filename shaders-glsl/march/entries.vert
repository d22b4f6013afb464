// A rectangle round the projection of a boundary face, a little larger than it: entries.frag decides which pixels' rays meet the
// face, by the same signs as the walk, and not the rasteriser, which snaps vertices.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/clipped_cells.h"
#include "shared/frame_view.h"
#include "shared/march.h"
#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"

#define MESH_CELLS 1
#define MESH_VERTICES 2
#define MESH_CELL_SCALARS 3
#include "include/mesh_access.glsl"
#include "include/view_space.glsl"

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
layout(binding = 4) uniform usamplerBuffer boundaryVertices;  // three per face

layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer UintsAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  UintsAt boundaryVerticesAt;
  UintsAt boundaryCellsAt;
  PixelBand band;
};

layout(location = 0) flat out uint boundaryFace;

// Pixels around the face that are drawn, too. More than the 1/256 to which rasterisers snap, and than the rounding of a
// projected position, 2^-24 of its terms.
const float kMargin = 1.0 / 32.0;
const float kRounding = 1e-6;

void main() {
  boundaryFace = gl_VertexIndex / MARCH_FACE_VERTICES;
  const uint corner = gl_VertexIndex % MARCH_FACE_VERTICES;
  vec3 position[4];
  for (uint i = 0; i < 3u; i++) {
    const uint at = 3u * boundaryFace + i;
    const uint vertex = kWideAddressing ? boundaryVerticesAt.data[at] : texelFetch(boundaryVertices, int(at)).x;
    position[i] = viewPosition(view, loadVertex(mesh, vertex).xyz);
  }
  position[3] = position[2];
  const vec3 depth = vec3(position[0].z, position[1].z, position[2].z);
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // beside the picture
  if (all(lessThanEqual(depth, vec3(0.0)))) return;

  const float margin = kMargin + view.pixelsPerUnit * kRounding * (1.0 + view.eyeMesh.w) /
                                     (kPerspective ? max(min(min(depth.x, depth.y), depth.z), 1e-30) : 1.0);
  vec2 origin = vec2(0.0);
  vec2 along = vec2(1.0, 0.0);
  vec2 low;
  vec2 high;
  if (isNearCell(vec4(depth, depth.z))) {
    const ScreenBox box = nearCellBox(view, position);
    low = box.low - 1.0;
    high = box.high + 1.0;
  } else {
    // Along the longest edge: then the rectangle is at most twice the triangle.
    vec2 screen[3];
    for (int i = 0; i < 3; i++) screen[i] = position[i].xy * (view.pixelsPerUnit / (kPerspective ? position[i].z : 1.0));
    const vec2 edge[3] = vec2[3](screen[1] - screen[0], screen[2] - screen[1], screen[0] - screen[2]);
    const vec3 squared = vec3(dot(edge[0], edge[0]), dot(edge[1], edge[1]), dot(edge[2], edge[2]));
    const float longest = max(max(squared.x, squared.y), squared.z);
    const vec2 direction = squared.x == longest ? edge[0] : squared.y == longest ? edge[1] : edge[2];
    if (longest > 0.0) along = direction * inversesqrt(longest);
    origin = screen[0];
    low = vec2(0.0);
    high = vec2(0.0);
    for (int i = 1; i < 3; i++) {
      const vec2 d = screen[i] - origin;
      const vec2 turned = vec2(dot(d, along), dot(d, vec2(-along.y, along.x)));
      low = min(low, turned);
      high = max(high, turned);
    }
    low -= margin;
    high += margin;
  }
  if (along.y == 0.0) {
    // Nothing far outside the picture, where rasterisers have no digits left.
    low = max(low, -view.halfSize - 2.0 - origin);
    high = min(high, view.halfSize + 2.0 - origin);
    if (any(greaterThan(low, high))) return;
  }
  const bvec2 isHigh = bvec2(corner == 1u || corner == 2u || corner == 4u, corner == 2u || corner >= 4u);
  const vec2 turned = mix(low, high, isHigh);
  const vec2 pixels = origin + along * turned.x + vec2(-along.y, along.x) * turned.y;
  gl_Position = vec4(pixels / view.halfSize, 0.0, 1.0);
}
