// A ray's segment inside one cell, from what include/fan_vertex.glsl hands on.
//
// Before including: shared/cell_push.h; what include/integrate.glsl wants, for all methods. CELL_PLANES is a binding number, or
// CELL_PLANES_FLAT is defined: then the planes come with the vertices (raster/gator.vert).
#include "shared/integration.h"

layout(constant_id = SPEC_PERSPECTIVE) const bool kPerspective = true;
layout(constant_id = SPEC_SILHOUETTE) const bool kSilhouette = false;  // all cells are clipped
layout(constant_id = SPEC_SUBPIXELS) const uint kSubpixels = 0;  // see include/fan_vertex.glsl
layout(constant_id = SPEC_INTERPOLATION) const uint kInterpolation = INTERPOLATION_PERSPECTIVE;

// Of clipped cells (include/project_cell.glsl): FAN_VERTICES per slot.
#ifdef CELL_PLANES_FLAT
layout(location = 3) flat in vec4 flatPlanes[FAN_VERTICES];
vec4 cellPlane(int slot, int i) { return flatPlanes[i]; }
#else
layout(binding = CELL_PLANES) uniform samplerBuffer cellPlanes;
vec4 cellPlane(int slot, int i) { return texelFetch(cellPlanes, slot * int(FAN_VERTICES) + i); }
#endif

// What include/project_cell.glsl gives a vertex. Under INTERPOLATION_SCREEN: depth and scalar of the front end, length of the segment,
// scalar of the back end. Under INTEGRATION_VERTEX: what classifyVertex() returns.
layout(location = 0) in vec4 fanEnds;
// Of the fan's centre: xy q of its front end, and the largest q difference; in the two other cases depth and length. z the cell's slot
// in the batch, doubled; odd for a cell that is clipped. One vector, because software devices pay for each with every triangle.
layout(location = 1) flat in vec3 fanCentre;
// Where kSubpixels > 0: how far the rasteriser's triangle lies beside the fan's, pixels.
layout(location = 2) in vec2 fanShift;

int fanSlot() { return int(fanCentre.z) >> 1; }
bool isClippedFan() { return (int(fanCentre.z) & 1) != 0; }

#include "include/integrate.glsl"

// Of a snapped triangle's area as a part of its own: below this it does not tell where a place was.
const float kLeastSnappedArea = 0.25;

struct Segment {
  float scalarFront;
  float scalarBack;
  float depthFront;
  float thickness;  // along the view direction, mesh units
};

// Length along a ray per depth.
float rayLengthPerDepth(vec2 screen) { return kPerspective ? sqrt(1.0 + dot(screen, screen)) : 1.0; }

// fanEnds at the pixel's centre. What is interpolated there belongs to a place fanShift away on the fan's own triangle; both triangles
// are affine images of each other, so a step on one is that times I - d fanShift on the other.
vec4 endsAtCentre() {
  if (kSubpixels == 0u) return fanEnds;
  const mat2 own = mat2(1.0) - mat2(dFdx(fanShift), dFdy(fanShift));
  // A triangle that snapping turns over, or nearly so, is no image of its own.
  const vec2 shift = determinant(own) > kLeastSnappedArea ? inverse(own) * fanShift : fanShift;
  return fanEnds + dFdx(fanEnds) * shift.x + dFdy(fanEnds) * shift.y;
}

// From the fan's vertices: both ends by division through the interpolated 1/depth, and the thickness from the
// interpolated difference, 1/q_b - 1/q_f = (q_f - q_b) / (q_f q_b).
//
// Rasterisers snap vertices to 1/256 pixel, so a pixel's centre may lie that far outside the triangle, which can be many
// times the width of a sliver: what is extrapolated is held to what the cell has.
//
// Older methods interpolate the length and the scalars themselves on the screen, as if the view were orthographic (Kraus et
// al. 2004, section 2.1, on what is wrong with that).
Segment fanSegment(vec2 screen) {
  const float perLength = 1.0 / rayLengthPerDepth(screen);
  // The fan's vertices have been classified: only the cell's place along the ray is left.
  if (kIntegration == INTEGRATION_VERTEX) return Segment(0.0, 0.0, fanCentre.x, fanCentre.y * perLength);
  const vec4 ends = endsAtCentre();
  if (kInterpolation == INTERPOLATION_SCREEN)
    return Segment(ends.y, ends.w, ends.x, clamp(ends.z, 0.0, fanCentre.y) * perLength);
  const float dq = clamp(ends.z, 0.0, fanCentre.y);
  if (!kPerspective) return Segment(ends.y, ends.w, -ends.x, dq);
  const float qFront = clamp(ends.x, fanCentre.x * NEAR_DEPTH_RATIO, fanCentre.x / NEAR_DEPTH_RATIO);
  const float depthFront = 1.0 / qFront;
  const float depthBack = 1.0 / max(qFront - dq, qFront * NEAR_DEPTH_RATIO);
  return Segment(ends.y * depthFront, ends.w * depthBack, depthFront, dq * depthFront * depthBack);
}

// From a clipped cell's planes (include/project_cell.glsl): the ray, origin + depth * direction, clipped against the four faces and
// the eye's plane. Depths are relative to that of vertex 0.
Segment clippedSegment(int slot, vec3 origin, vec3 direction) {
  vec4 plane[4];
  for (int i = 0; i < 4; i++) plane[i] = cellPlane(slot, i);
  const vec3 vertex0 = vec3(plane[1].w, plane[2].w, plane[3].w);
  const vec3 start = origin + direction * vertex0.z - vertex0;
  float front = -vertex0.z;
  float back = 1e30;
  vec4 offset;
  vec4 slope;
  for (int i = 0; i < 4; i++) {
    offset[i] = dot(plane[i].xyz, start) + (i == 0 ? plane[0].w : 0.0);
    slope[i] = dot(plane[i].xyz, direction);
    const float depth = -offset[i] / slope[i];
    front = slope[i] > 0.0 ? max(front, depth) : front;
    back = slope[i] < 0.0 ? min(back, depth) : back;
    // A ray that lies in a face belongs to one of the two cells there, as if it were moved aside by next to nothing.
    const float side = plane[i].x != 0.0 ? plane[i].x : plane[i].y;
    if (slope[i] == 0.0 && (offset[i] < 0.0 || (offset[i] == 0.0 && side <= 0.0))) back = -1e30;
  }
  // The scalar as a convex combination of the vertices' values: it stays in their range whatever the rounding.
  const vec4 scalar = cellPlane(slot, 4);
  const vec4 weightFront = max(offset + slope * front, vec4(0.0));
  const vec4 weightBack = max(offset + slope * back, vec4(0.0));
  return Segment(dot(weightFront, scalar) / max(dot(weightFront, vec4(1.0)), 1e-37),
                 dot(weightBack, scalar) / max(dot(weightBack, vec4(1.0)), 1e-37), vertex0.z + front,
                 max(back - front, 0.0));
}

// The segment of this fragment's ray.
//   screen   the ray's direction, x/z and y/z (perspective), or its position
Segment fragmentSegment(vec2 screen) {
  Segment segment = fanSegment(screen);
  if (kSilhouette || isClippedFan())
    segment = kPerspective ? clippedSegment(fanSlot(), vec3(0.0), vec3(screen, 1.0))
                           : clippedSegment(fanSlot(), vec3(screen, 0.0), vec3(0.0, 0.0, 1.0));
  return segment;
}

vec2 screenOf(vec4 fragCoord, ScreenScale scale) {
  return vec2(fragCoord.x - scale.halfSize.x, scale.halfSize.y - fragCoord.y) * scale.unitsPerPixel;
}

// Light, premultiplied, and opacity of this fragment's segment.
vec4 fragmentColor(Segment segment, vec2 screen) {
  if (kIntegration == INTEGRATION_VERTEX && !kSilhouette && !isClippedFan()) {
    // What is extrapolated, see above, is held to what there can be.
    const vec4 ends = endsAtCentre();
    return vertexLight(vec4(max(ends.rgb, vec3(0.0)), clamp(ends.a, 0.0, 1.0)));
  }
  return integrateSegment(segment.scalarFront, segment.scalarBack, segment.thickness * rayLengthPerDepth(screen));
}
