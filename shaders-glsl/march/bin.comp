// Cuts every boundary face that a ray may enter through (or leave through, when the eye may be inside the mesh) into jobs: one for
// each tile of pixels that it may cover. Faces that no pixel's ray meets are dropped here.
//
// What is dropped is certain to be missed: enter.comp decides which rays meet the face, by the same signs as the walk.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/clipped_cells.h"
#include "shared/frame_view.h"
#include "shared/march.h"
#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"

layout(local_size_x = MARCH_WORKGROUP) in;

#define MESH_CELLS 1
#define MESH_VERTICES 2
#define MESH_CELL_SCALARS 3
#include "include/dispatch.glsl"
#include "include/dealt_workgroups.glsl"
#include "include/mesh_access.glsl"
#include "include/view_space.glsl"

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
layout(binding = 4) uniform usamplerBuffer boundary;  // three vertices, (b - a) x (c - a) points outwards, and the face's code
layout(binding = 5, scalar) writeonly buffer Jobs { uvec4 jobs[]; };  // face, tile and place, first node
layout(binding = 6, scalar) buffer TileMarks { uint tileMarks[]; };   // bit 0: is in walkTiles
layout(binding = 7, scalar) writeonly buffer WalkTiles { uint walkTiles[]; };
layout(binding = 8, scalar) buffer Counts { MarchCounts counts; };

layout(constant_id = SPEC_JOB_LANES) const uint kJobLanes = 1;  // invocations of enter.comp to a job

layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer FacesAt { uvec4 data[]; };
layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  FacesAt boundaryAt;
  PixelBand band;
  uint faceCount;
  uint jobCapacity;
};

// Pixels around the face that count as covered: far more than the rounding of a projected position, 2^-24 of its terms.
const float kMargin = 1.0 / 32.0;
const float kRounding = 1e-6;

// The pixels of a face, and its outline in coordinates in which pixel centres are whole numbers and rows go down.
struct Outline {
  ivec2 first, last;  // columns and rows of the picture; none: first > last
  vec2 corner[3];
  float margin;
  bool isBox;  // reaches behind the eye: there is no outline, only the box
};

Outline outlineOf(uvec4 vertices) {
  Outline outline;
  outline.first = ivec2(0);
  outline.last = ivec2(-1);
  vec3 position[4];
  for (uint i = 0; i < 3u; i++) position[i] = viewPosition(view, loadVertex(mesh, vertices[i]).xyz);
  position[3] = position[2];
  const vec3 depth = vec3(position[0].z, position[1].z, position[2].z);
  const float nearest = min(min(depth.x, depth.y), depth.z);
  outline.margin =
      kMargin + view.pixelsPerUnit * kRounding * (1.0 + view.eyeMesh.w) / (kPerspective ? max(nearest, 1e-30) : 1.0);
  outline.isBox = isNearCell(vec4(depth, depth.z));
  for (int i = 0; i < 3; i++) {
    const vec2 screen = position[i].xy * (view.pixelsPerUnit / (kPerspective && !outline.isBox ? position[i].z : 1.0));
    outline.corner[i] = vec2(screen.x, -screen.y) + view.halfSize - 0.5;
  }
  vec2 low = min(min(outline.corner[0], outline.corner[1]), outline.corner[2]) - outline.margin;
  vec2 high = max(max(outline.corner[0], outline.corner[1]), outline.corner[2]) + outline.margin;
  if (outline.isBox) {
    const ScreenBox box = nearCellBox(view, position);
    low = vec2(box.low.x, -box.high.y) + view.halfSize - 1.5;
    high = vec2(box.high.x, -box.low.y) + view.halfSize + 0.5;
  }
  if (all(lessThanEqual(depth, vec3(0.0)))) return outline;
  const vec2 lowest = vec2(0.0, float(band.firstRow));
  const vec2 highest = vec2(float(band.width - 1u), float(band.firstRow + band.rowCount - 1u));
  outline.first = ivec2(ceil(max(low, lowest)));
  outline.last = ivec2(floor(min(high, highest)));
  // Where far corners have no digits left, or are beyond the range of integers.
  if (any(greaterThan(low, highest)) || any(lessThan(high, lowest))) outline.last = outline.first - 1;
  return outline;
}

float turn(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// The least that the rectangle's points lie outside an edge, times the edge's length; negative: some lie inside.
//   winding   of the outline, 1 or -1
float outside(vec2 from, vec2 to, float winding, vec2 center, vec2 halfSize) {
  const vec2 edge = (to - from) * winding;
  return -turn(edge, center - from) - dot(abs(edge.yx), halfSize);
}

void addJob(uint face, uint tile, uvec2 first, uvec2 last) {
  const uint job = atomicAdd(counts.jobs, 1u);
  if (job >= jobCapacity) return;
  if (job % (MARCH_WORKGROUP / kJobLanes) == 0u) atomicAdd(counts.jobGroups, 1u);
  // Nodes for all its pixels at once: drawn one by one, they would keep processors waiting for each other.
  const uvec2 size = last - first + 1u;
  const uint node = atomicAdd(counts.nodes, size.x * size.y);
  const uint place = (tile << MARCH_JOB_PLACE_BITS) | first.x | (first.y << 3) | (last.x << 6) | (last.y << 9);
  jobs[job] = uvec4(face, place, node, 0u);
  if (atomicOr(tileMarks[tile], 1u) == 0u) walkTiles[atomicAdd(counts.walkTiles, 1u)] = tile;
}

void main() {
  const uint face = dealtIndex();
  if (face >= faceCount) return;
  const uvec4 vertices = kWideAddressing ? boundaryAt.data[face] : texelFetch(boundary, int(face));
  const Outline outline = outlineOf(vertices);
  if (any(greaterThan(outline.first, outline.last))) return;

  const vec2 a = outline.corner[0];
  const vec2 b = outline.corner[1];
  const vec2 c = outline.corner[2];
  const float area = turn(b - a, c - a);
  const float winding = area < 0.0 ? -1.0 : 1.0;
  const vec3 lengths = vec3(length(b - a), length(c - b), length(a - c));
  // Rows go down: seen from outside, corners run clockwise here and the area is negative.
  const bool isBack = !outline.isBox && area > 4.0 * outline.margin * (lengths.x + lengths.y + lengths.z);
  if (isBack && !kNearCells) return;

  const uvec2 first = uvec2(outline.first.x, outline.first.y - int(band.firstRow));
  const uvec2 last = uvec2(outline.last.x, outline.last.y - int(band.firstRow));
  const uvec2 firstTile = first / MARCH_TILE;
  const uvec2 tiles = last / MARCH_TILE - firstTile + 1u;
  const uint columns = (band.width + MARCH_TILE - 1u) / MARCH_TILE;
  uvec2 at = uvec2(0u);
  for (uint i = 0; i < 65000u; i++) {
    const uvec2 origin = (firstTile + at) * MARCH_TILE;
    const uvec2 low = max(first, origin);
    const uvec2 high = min(last, origin + (MARCH_TILE - 1u));
    const vec2 halfSize = 0.5 * vec2(high - low);
    const vec2 center = vec2(low) + vec2(0.0, float(band.firstRow)) + halfSize;
    const vec3 out3 = vec3(outside(a, b, winding, center, halfSize), outside(b, c, winding, center, halfSize),
                           outside(c, a, winding, center, halfSize));
    if (outline.isBox || all(lessThanEqual(out3, outline.margin * lengths)))
      addJob(face, (firstTile.y + at.y) * columns + firstTile.x + at.x, low - origin, high - origin);
    at.x++;
    if (at.x == tiles.x) at = uvec2(0u, at.y + 1u);
    if (at.y == tiles.y) break;
  }
}
