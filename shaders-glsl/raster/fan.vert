// One vertex of a projected cell's fan.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/integration.h"
#include "shared/raster_push.h"
#include "shared/spec_ids.h"

#define TRANSFER_PIECES 2
#define TRANSFER_PIECE_BINS 3
#include "include/integration/transfer_pieces.glsl"
#include "include/integration/segment_functions.glsl"
#include "include/integration/vertex.glsl"

layout(constant_id = SPEC_PERSPECTIVE) const bool kPerspective = true;
layout(constant_id = SPEC_INTEGRATION) const uint kIntegration = INTEGRATION_EXACT;
layout(constant_id = SPEC_INTERPOLATION) const uint kInterpolation = INTERPOLATION_PERSPECTIVE;

layout(location = 0) in vec2 position;  // ndc
layout(location = 1) in vec4 ends;      // see project/project.comp

layout(binding = 0) uniform usamplerBuffer cellModes;

layout(push_constant, scalar) uniform Push { RasterPush push; };

layout(location = 0) out vec4 fanEnds;        // see include/fan_segment.glsl
layout(location = 1) flat out vec2 thickEnds;  // of the triangle's first vertex, which is the fan's centre
layout(location = 2) flat out int fanCell;     // slot in the batch, doubled; odd for a cell that is clipped

// Both ends of the ray at this vertex: x depth of the front end, y its scalar, z length between the ends, w scalar at the back.
vec4 vertexSegment() {
  if (!kPerspective) return vec4(-ends.x, ends.y, ends.z, ends.w);
  const float depthFront = 1.0 / ends.x;
  const float depthBack = 1.0 / (ends.x - ends.z);
  const vec2 screen = position * push.halfSize * push.unitsPerPixel;
  return vec4(depthFront, ends.y * depthFront, ends.z * depthFront * depthBack * sqrt(1.0 + dot(screen, screen)),
              ends.w * depthBack);
}

void main() {
  gl_Position = vec4(position, 0.0, 1.0);
  fanEnds = ends;
  thickEnds = ends.xz;
  if (kInterpolation == INTERPOLATION_SCREEN) {
    fanEnds = vertexSegment();
    thickEnds = fanEnds.xz;
  }
  if (kIntegration == INTEGRATION_VERTEX) {
    const vec4 segment = vertexSegment();
    fanEnds = classifyVertex(segment.y, segment.w, segment.z);
    thickEnds = segment.xz;
  }
  const int slot = gl_VertexIndex / int(FAN_VERTICES);
  fanCell = slot * 2 + int(texelFetch(cellModes, slot).x);
}
