// One vertex of what is drawn of a cell, handed to include/fan_segment.glsl.
//
// Before including: shared/cell_push.h, shared/spec_ids.h, `CellPush push`, a constant kPerspective, and what
// include/integration/transfer_pieces.glsl wants.
#include "shared/integration.h"
#include "include/integration/transfer_pieces.glsl"
#include "include/integration/segment_functions.glsl"
#include "include/integration/vertex.glsl"

layout(constant_id = SPEC_INTEGRATION) const uint kIntegration = INTEGRATION_EXACT;
layout(constant_id = SPEC_INTERPOLATION) const uint kInterpolation = INTERPOLATION_PERSPECTIVE;

// Rasterisers snap vertices to a grid. Where they also interpolate between the snapped ones (NVIDIA's do, Mesa's software device does
// not), what a fragment gets belongs up to 1/362 pixel beside its centre. So vertices are snapped to the same grid here, and by how
// much is handed on: include/fan_segment.glsl takes it back.
layout(constant_id = SPEC_SUBPIXELS) const uint kSubpixels = 0;

layout(location = 0) out vec4 fanEnds;        // see include/fan_segment.glsl
layout(location = 1) flat out vec3 fanCentre;  // of the triangle's first vertex
layout(location = 2) out vec2 fanShift;        // from the vertex to where it is snapped, pixels, y down

// Both ends of the ray at a vertex: x depth of the front end, y its scalar, z length between the ends, w scalar at the back.
vec4 vertexSegment(vec2 position, vec4 ends) {
  if (!kPerspective) return vec4(-ends.x, ends.y, ends.z, ends.w);
  const float depthFront = 1.0 / ends.x;
  const float depthBack = 1.0 / (ends.x - ends.z);
  const vec2 screen = position * push.scale.halfSize * push.scale.unitsPerPixel;
  return vec4(depthFront, ends.y * depthFront, ends.z * depthFront * depthBack * sqrt(1.0 + dot(screen, screen)),
              ends.w * depthBack);
}

// Places a vertex, snapped or not.
//   position   ndc
void placeVertex(vec2 position) {
  gl_Position = vec4(position, 0.0, 1.0);
  fanShift = vec2(0.0);
  if (kSubpixels == 0u) return;
  const vec2 halfSize = push.scale.halfSize;
  const float steps = float(kSubpixels);
  const vec2 snapped = round((position * halfSize + halfSize) * steps) / steps - halfSize;  // pixels from the image's centre
  gl_Position.xy = snapped / halfSize;
  fanShift = vec2(-1.0, 1.0) * fma(position, halfSize, -snapped);
}

//   position   ndc
//   ends       see include/project_cell.glsl
//   slot       the cell's in its batch
void handOnVertex(vec2 position, vec4 ends, int slot, bool isClipped) {
  placeVertex(position);
  fanEnds = ends;
  fanCentre.xy = ends.xz;
  if (kInterpolation == INTERPOLATION_SCREEN) {
    fanEnds = vertexSegment(position, ends);
    fanCentre.xy = fanEnds.xz;
  }
  if (kIntegration == INTEGRATION_VERTEX) {
    const vec4 segment = vertexSegment(position, ends);
    fanEnds = classifyVertex(segment.y, segment.w, segment.z);
    fanCentre.xy = segment.xz;
  }
  fanCentre.z = float(slot * 2 + (isClipped ? 1 : 0));
}
