// The colour and the depth of the opaque surface that ends each pixel's ray.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/appearance.h"
#include "shared/clipped_cells.h"
#include "shared/frame_view.h"
#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

#include "include/dispatch.glsl"
#define SURFACE_VERTICES 1
#include "include/surface_ray.glsl"
#define APPEARANCE_TEXELS 2
#include "include/march/appearance_texels.glsl"
#include "include/march/illumination.glsl"
#include "include/march/ray_direction.glsl"

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
layout(binding = 3) uniform usamplerBuffer triangles;
layout(binding = 4) uniform samplerBuffer surfaceNormals;    // per vertex, any length
layout(binding = 5) uniform samplerBuffer surfaceMaterials;  // per surface: rgb, shading (SHADING_*); rgb of the back
layout(binding = 6, scalar) readonly buffer Chosen { uint chosen[]; };
layout(binding = 7, scalar) writeonly buffer RayEnds { vec4 rayEnds[]; };

layout(push_constant, scalar) uniform Push { PixelBand band; };

vec3 position(uint vertex) { return texelFetch(surfaceVertices, int(vertex)).xyz; }
vec3 normalAt(uint vertex) { return texelFetch(surfaceNormals, int(vertex)).xyz; }

void main() {
  const uint pixel = linearIndex();
  if (pixel >= band.width * band.rowCount) return;
  const uint triangle = chosen[pixel];
  rayEnds[pixel] = vec4(0.0, 0.0, 0.0, NO_RAY_END);
  if (triangle == NO_TRIANGLE) return;
  const uvec4 corners = texelFetch(triangles, int(triangle));
  const uvec2 place = uvec2(pixel % band.width, band.firstRow + pixel / band.width);
  const TriangleMeeting met = meetTriangle(view, place, corners.xyz);
  const vec4 front = texelFetch(surfaceMaterials, 2 * int(corners.w));
  const vec4 back = texelFetch(surfaceMaterials, 2 * int(corners.w) + 1);
  vec3 color = met.isAnticlockwise ? front.rgb : back.rgb;
  if (front.w != float(SHADING_NONE)) {
    vec3 normal = cross(position(corners.y) - position(corners.x), position(corners.z) - position(corners.x));
    if (front.w == float(SHADING_PHONG))
      normal = met.share.x * normalAt(corners.x) + met.share.y * normalAt(corners.y) + met.share.z * normalAt(corners.z);
    const Illumination lit = illuminate(normal, directionToEye(view, place));
    color = color * lit.factor + lit.highlight;
  }
  rayEnds[pixel] = vec4(color, met.depth);
}
