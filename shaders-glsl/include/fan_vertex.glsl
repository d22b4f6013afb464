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

layout(location = 0) out vec4 fanEnds;        // see include/fan_segment.glsl
layout(location = 1) flat out vec2 thickEnds;  // of the triangle's first vertex, which is the fan's centre
layout(location = 2) flat out int fanCell;     // slot in the batch, doubled; odd for a cell that is clipped

// Both ends of the ray at a vertex: x depth of the front end, y its scalar, z length between the ends, w scalar at the back.
vec4 vertexSegment(vec2 position, vec4 ends) {
  if (!kPerspective) return vec4(-ends.x, ends.y, ends.z, ends.w);
  const float depthFront = 1.0 / ends.x;
  const float depthBack = 1.0 / (ends.x - ends.z);
  const vec2 screen = position * push.scale.halfSize * push.scale.unitsPerPixel;
  return vec4(depthFront, ends.y * depthFront, ends.z * depthFront * depthBack * sqrt(1.0 + dot(screen, screen)),
              ends.w * depthBack);
}

//   position   ndc
//   ends       see include/project_cell.glsl
//   slot       the cell's in its batch
void handOnVertex(vec2 position, vec4 ends, int slot, bool isClipped) {
  gl_Position = vec4(position, 0.0, 1.0);
  fanEnds = ends;
  thickEnds = ends.xz;
  if (kInterpolation == INTERPOLATION_SCREEN) {
    fanEnds = vertexSegment(position, ends);
    thickEnds = fanEnds.xz;
  }
  if (kIntegration == INTEGRATION_VERTEX) {
    const vec4 segment = vertexSegment(position, ends);
    fanEnds = classifyVertex(segment.y, segment.w, segment.z);
    thickEnds = segment.xz;
  }
  fanCell = slot * 2 + (isClipped ? 1 : 0);
}
