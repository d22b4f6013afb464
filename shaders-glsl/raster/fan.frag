// A ray's segment inside one cell: light and opacity.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/near_cells.h"
#include "shared/raster_push.h"
#include "shared/spec_ids.h"

layout(constant_id = SPEC_PERSPECTIVE) const bool kPerspective = true;
layout(constant_id = SPEC_NEAR_CELLS) const bool kNearCells = false;

layout(binding = 1) uniform samplerBuffer cellPlanes;  // of near cells: FAN_VERTICES per slot
#define TRANSFER_PIECES 2
#define TRANSFER_PIECE_BINS 3
#include "include/integrate.glsl"

layout(push_constant, scalar) uniform Push { RasterPush push; };

layout(location = 0) in vec4 fanEnds;
layout(location = 1) flat in vec2 thickEnds;  // of the fan's centre: q of its front end, and the largest q difference
layout(location = 2) flat in int nearCell;

layout(location = 0) out vec4 color;  // premultiplied light, opacity

struct Segment {
  float scalarFront;
  float scalarBack;
  float thickness;  // along the view direction, mesh units
};

// From the fan's vertices: both ends by division through the interpolated 1/depth, and the thickness from the
// interpolated difference, 1/q_b - 1/q_f = (q_f - q_b) / (q_f q_b).
//
// Rasterisers snap vertices to 1/256 pixel, so a pixel's centre may lie that far outside the triangle, which can be many
// times the width of a sliver: what is extrapolated is held to what the cell has.
Segment fanSegment() {
  const float dq = clamp(fanEnds.z, 0.0, thickEnds.y);
  if (!kPerspective) return Segment(fanEnds.y, fanEnds.w, dq);
  const float qFront = clamp(fanEnds.x, thickEnds.x * NEAR_DEPTH_RATIO, thickEnds.x / NEAR_DEPTH_RATIO);
  const float depthFront = 1.0 / qFront;
  const float depthBack = 1.0 / max(qFront - dq, qFront * NEAR_DEPTH_RATIO);
  return Segment(fanEnds.y * depthFront, fanEnds.w * depthBack, dq * depthFront * depthBack);
}

// From a near cell's planes: the ray, origin + depth * direction, clipped against the four faces and the eye's plane.
Segment nearSegment(vec3 origin, vec3 direction) {
  float front = 0.0;
  float back = 1e30;
  vec4 offset;
  vec4 slope;
  for (int i = 0; i < 4; i++) {
    const vec4 plane = texelFetch(cellPlanes, nearCell * int(FAN_VERTICES) + i);
    offset[i] = dot(plane.xyz, origin) + plane.w;
    slope[i] = dot(plane.xyz, direction);
    const float depth = -offset[i] / slope[i];
    front = slope[i] > 0.0 ? max(front, depth) : front;
    back = slope[i] < 0.0 ? min(back, depth) : back;
    if (slope[i] == 0.0 && offset[i] <= 0.0) back = -1.0;
  }
  // The scalar as a convex combination of the vertices' values: it stays in their range whatever the rounding.
  const vec4 scalar = texelFetch(cellPlanes, nearCell * int(FAN_VERTICES) + 4);
  const vec4 weightFront = max(offset + slope * front, vec4(0.0));
  const vec4 weightBack = max(offset + slope * back, vec4(0.0));
  return Segment(dot(weightFront, scalar) / max(dot(weightFront, vec4(1.0)), 1e-37),
                 dot(weightBack, scalar) / max(dot(weightBack, vec4(1.0)), 1e-37), max(back - front, 0.0));
}

void main() {
  const vec2 screen = vec2(gl_FragCoord.x - push.halfSize.x, push.halfSize.y - gl_FragCoord.y) * push.unitsPerPixel;
  Segment segment = fanSegment();
  if (kNearCells && nearCell >= 0)
    segment = kPerspective ? nearSegment(vec3(0.0), vec3(screen, 1.0)) : nearSegment(vec3(screen, 0.0), vec3(0.0, 0.0, 1.0));
  const float lengthPerDepth = kPerspective ? sqrt(1.0 + dot(screen, screen)) : 1.0;
  color = integrateSegment(segment.scalarFront, segment.scalarBack, segment.thickness * lengthPerDepth);
}
