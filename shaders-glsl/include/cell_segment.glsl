// A ray's segment inside one cell with all that is shown beside the volume (docs/appearance.md), for cells that are drawn one by one: what
// fan_segment.glsl is for a volume alone. Cells are drawn as outlines, a little too large.
//
// Where a ray meets a face, and with which scalar, is computed from the face's three corners in the order of their indices, by the same operations for both of
// its cells: so each surface in a shared face is counted once, and a ray that is beside one cell is in the next.
//
// Before including: shared/limits.h, shared/clipped_cells.h, shared/cell_push.h, shared/frame_view.h, shared/integration.h, shared/spec_ids.h,
// shared/visibility.h. Binds 1 to 14.
#define APPEARANCE
layout(constant_id = SPEC_ISOSURFACES) const bool kIsosurfaces = false;
layout(constant_id = SPEC_VOLUME) const bool kVolume = true;

#define TRANSFER_PIECES 2
#define TRANSFER_PIECE_BINS 3
#define MESH_CELLS 4
#define MESH_VERTICES 5
#define MESH_CELL_SCALARS 6
#define TRANSFER_POINTS 8
#define TRANSFER_POINT_SCALARS 9
#define APPEARANCE_TEXELS 10
#define VERTEX_GRADIENTS 11
#define RAY_ENDS 12
#define VERTEX_NUMBERS 13
#define VERTEX_COLORS 14
#include "include/integration/exact.glsl"
#include "include/integration/ray_parts.glsl"
#include "include/mesh_access.glsl"
#include "include/real.glsl"
#include "include/view_space.glsl"
#include "include/ray_signs.glsl"
#include "include/face_meeting.glsl"
#include "include/march/appearance_texels.glsl"
#include "include/march/illumination.glsl"
#include "include/march/ray_direction.glsl"
#include "include/march/visible_range.glsl"
#include "include/march/isosurface.glsl"
#include "include/march/classification.glsl"
#include "include/march/visible_segment.glsl"

layout(binding = 1, scalar) uniform FrameViewBlock { FrameView view; };
layout(binding = 7) uniform usamplerBuffer cellOrder;  // cells of slots
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer CellOrderAt { uint data[]; };

layout(push_constant, scalar) uniform Push {
  CellPush push;
  MeshAddresses mesh;
  CellOrderAt orderAt;
};

layout(location = 1) flat in vec3 fanCentre;  // z: the cell's slot in the batch, doubled

int fanSlot() { return int(fanCentre.z) >> 1; }

struct Segment {
  float depthFront;
  float thickness;  // along the view direction, mesh units
  bool isMet;
  uint cell;
  Face enter, leave;
  Place entered, left;
};

vec2 screenOf(vec4 fragCoord, ScreenScale scale) { return fragCoord.xy; }

Corner cellCorner(Ray ray, uint index) {
  const vec4 v = loadVertex(mesh, index);
  return seenCorner(ray, Vertex(index, v.xyz, v.w));
}

//   a, b, c   in the order of their indices
void meetFace(Corner a, Corner b, Corner c, inout Segment segment, inout uint met) {
  const bool leftAB = isLeft(a, b);
  if (leftAB != isLeft(b, c) || leftAB != isLeft(c, a)) return;
  Face face = Face(a, b, c);
  if (!leftAB) face = Face(a, c, b);
  const Place there = meeting(face).there;
  const bool isFirst = met == 0u || there.depth < segment.entered.depth;
  if (met == 0u || !isFirst) {
    segment.leave = face;
    segment.left = there;
  } else {
    segment.leave = segment.enter;
    segment.left = segment.entered;
  }
  if (isFirst) {
    segment.enter = face;
    segment.entered = there;
  }
  met++;
}

Segment fragmentSegment(vec2 pixelCentre) {
  const Ray ray = pixelRay(view, uvec2(pixelCentre));
  const uint slot = push.firstSlot + uint(fanSlot());
  Segment segment;
  segment.cell = kWideAddressing ? orderAt.data[slot] : texelFetch(cellOrder, int(slot)).x;
  const uvec4 vertices = loadCellVertices(mesh, segment.cell);
  const Corner a = cellCorner(ray, vertices.x);
  const Corner b = cellCorner(ray, vertices.y);
  const Corner c = cellCorner(ray, vertices.z);
  const Corner d = cellCorner(ray, vertices.w);
  segment.enter = Face(a, b, c);
  segment.leave = segment.enter;
  segment.entered = Place(0.0, 0.0);
  segment.left = segment.entered;
  uint met = 0u;
  meetFace(a, b, c, segment, met);
  meetFace(a, b, d, segment, met);
  meetFace(a, c, d, segment, met);
  meetFace(b, c, d, segment, met);
  segment.isMet = met >= 2u;
  segment.depthFront = segment.entered.depth - ray.eyeDepth;
  segment.thickness = segment.left.depth - segment.entered.depth;
  return segment;
}

// Light, premultiplied, and opacity of this fragment's segment.
vec4 fragmentColor(Segment segment, vec2 pixelCentre) {
  if (!segment.isMet) return vec4(0.0);
  const uvec2 pixel = uvec2(pixelCentre);
  const Ray ray = pixelRay(view, pixel);
  const VisibleRange range = visibleRange(view, ray, pixel, 0u);
  const vec3 toEye = directionToEye(view, pixel);
  const VisibleSegment visible = visibleSegment(mesh, ray, range, segment.cell, segment.entered, segment.left);
  if (!visible.isVisible) return vec4(0.0);
  RayParts parts = beginRay(visible.front, visible.back, visible.thickness);
  ClassifiedWalk classified;
  if (kClassified)
    classified = beginClassified(visible, faceAttributes(segment.enter), faceAttributes(segment.leave), toEye);
  vec3 light = vec3(0.0);
  float opacity = 0.0;
  float clearness = 1.0;
  for (int surfaceRound = 0; surfaceRound < kMostParts; surfaceRound++) {
    bool isThrough = false;
    for (int round = 0; round < kMostParts; round++) {
      parts.surface = -1.0;
      const bool isLast = kClassified ? walkClassifiedPart(classified, parts, light, opacity, clearness)
                                      : walkRayPart(parts, light, opacity, clearness);
      isThrough = isLast || isWalkOpaque(opacity, clearness);
      if (isThrough || (kIsosurfaces && parts.surface >= 0.0)) break;
    }
    if (!kIsosurfaces) break;
    if (isThrough) break;
    const float share =
        clamp((parts.scalar - segment.entered.scalar) / (segment.left.scalar - segment.entered.scalar), 0.0, 1.0);
    addSurface(int(parts.surface), parts.rising, mesh, segment.cell, segment.enter, segment.leave, share, toEye, light, opacity,
               clearness);
    if (isWalkOpaque(opacity, clearness)) break;
  }
  return vec4(light, kEmissionPerLength ? 1.0 - clearness : opacity);
}
