// Which cells can show, and how far away they are.
//
// One invocation per cell: its sort key (farthest first), marked KEY_TRANSPARENT when the cell neither absorbs nor emits
// anywhere in its scalar range; KEY_OUTSIDE when it is outside the picture or holds no pixel centre.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "shared/counters.h"
#include "shared/frame_view.h"
#include "shared/limits.h"
#include "shared/clipped_cells.h"
#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

#define MESH_CELLS 1
#define MESH_VERTICES 2
#define MESH_CELL_SCALARS 3
#define SUPPORT_INTERVALS 4
#include "include/dispatch.glsl"
#include "include/mesh_access.glsl"
#include "include/support.glsl"
#include "include/view_space.glsl"

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
layout(binding = 5, scalar) writeonly buffer Keys { uint keys[]; };
layout(binding = 6, scalar) buffer Counters { FrameCounters counters; };

layout(buffer_reference, scalar, buffer_reference_align = 4) writeonly buffer KeysAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  KeysAt keysAt;
};

const uint kVisible = 0;
const uint kOutside = 1;
const uint kNoSample = 2;
const uint kTransparent = 3;

// Rasterisers snap vertices to 1/256 pixel; a cell this close to a pixel's centre may still be drawn there.
const float kSampleMargin = 1.0 / 128.0;

// With so many pixel centres in its box, a cell is not tested against each of them.
const float kTestedSamples = 4.0;

// Pixel centres inside a box, as indices of columns (from the left) and rows (from the bottom).
struct SampleRange {
  vec2 first;
  vec2 last;
};

SampleRange samplesIn(ScreenBox box) {
  return SampleRange(max(ceil(box.low + view.halfSize - (0.5 + kSampleMargin)), vec2(0.0)),
                     min(floor(box.high + view.halfSize - (0.5 - kSampleMargin)), 2.0 * view.halfSize - 1.0));
}

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Whether one of a few pixel centres lies in the cell's projection: on no outer edge's far side. An edge between two
// projected vertices is an outer one when the other two vertices lie on one side of it.
bool coversASample(vec3 position[4], SampleRange samples) {
  vec2 screen[4];
  for (int i = 0; i < 4; i++) screen[i] = position[i].xy * (view.pixelsPerUnit / (kPerspective ? position[i].z : 1.0));
  const ivec4 pairs[6] = ivec4[6](ivec4(0, 1, 2, 3), ivec4(0, 2, 1, 3), ivec4(0, 3, 1, 2), ivec4(1, 2, 0, 3),
                                  ivec4(1, 3, 0, 2), ivec4(2, 3, 0, 1));
  const vec2 count = samples.last - samples.first + 1.0;
  bvec4 inside = lessThan(vec4(0.0, 1.0, 2.0, 3.0), vec4(count.x * count.y));
  for (int p = 0; p < 6; p++) {
    const vec2 base = screen[pairs[p].x];
    const vec2 edge = screen[pairs[p].y] - base;
    const float side0 = cross2(edge, screen[pairs[p].z] - base);
    const float side1 = cross2(edge, screen[pairs[p].w] - base);
    const float sense = side0 + side1 >= 0.0 ? 1.0 : -1.0;
    const bool isOuter = side0 * sense >= 0.0 && side1 * sense >= 0.0;
    const float margin = kSampleMargin * (abs(edge.x) + abs(edge.y));
    for (int i = 0; i < 4; i++) {
      const vec2 index = samples.first + vec2(mod(float(i), count.x), floor(float(i) / count.x));
      const vec2 centre = index + 0.5 - view.halfSize;
      inside[i] = inside[i] && !(isOuter && cross2(edge, centre - base) * sense < -margin);
    }
  }
  return any(inside);
}

uint visibility(ScreenBox box, vec3 position[4], bool isNear) {
  if (any(greaterThan(box.low, view.halfSize)) || any(lessThan(box.high, -view.halfSize))) return kOutside;
  const SampleRange samples = samplesIn(box);
  if (any(greaterThan(samples.first, samples.last))) return kNoSample;
  const vec2 count = samples.last - samples.first + 1.0;
  if (!isNear && count.x * count.y <= kTestedSamples && !coversASample(position, samples)) return kNoSample;
  return kVisible;
}

bool isInSupport(vec4 scalar) {
  return isInSupport(min(min(scalar.x, scalar.y), min(scalar.z, scalar.w)), max(max(scalar.x, scalar.y), max(scalar.z, scalar.w)),
                     view.supportCount);
}

// Distance of the centroid from the eye (less |eye|, so that digits are kept when the eye is far away) or depth.
float centroidDistance(vec3 position[4]) {
  const vec3 middle = 0.25 * (position[0] + position[1] + position[2] + position[3]);
  if (!kPerspective) return dot(view.viewFromMesh[2].xyz, middle) + view.viewFromMesh[2].w;
  const float distance = length(middle - view.eyeMesh.xyz);
  return dot(middle, middle - 2.0 * view.eyeMesh.xyz) / (distance + view.eyeMesh.w);
}

void main() {
  const uint cellIndex = linearIndex();
  if (cellIndex >= view.cellCount) return;
  const Cell cell = loadCell(mesh, cellIndex);
  vec3 position[4];
  for (int i = 0; i < 4; i++) position[i] = viewPosition(view, cell.position[i]);
  const vec4 depth = vec4(position[0].z, position[1].z, position[2].z, position[3].z);

  uint verdict = kOutside;
  if (any(greaterThan(depth, vec4(0.0)))) {
    const bool isNear = isNearCell(depth);
    ScreenBox box = pointsBox(view, position);
    if (isNear) box = nearCellBox(view, position);
    verdict = visibility(box, position, isNear);
  }
  if (verdict == kVisible && !isInSupport(cell.scalar)) verdict = kTransparent;

  const float largestKey = float((1u << view.keyBits) - 1u);
  const float share = clamp((centroidDistance(cell.position) - view.keyLow) * view.keyPerDistance, 0.0, 1.0);
  const uint distanceKey = uint(largestKey - share * largestKey);
  const uint key = verdict == kVisible       ? distanceKey
                   : verdict == kTransparent ? distanceKey | KEY_TRANSPARENT
                                             : KEY_OUTSIDE;
  if (kWideAddressing)
    keysAt.data[cellIndex] = key;
  else
    keys[cellIndex] = key;

  // One addition per subgroup and count.
  const uint outside = subgroupBallotBitCount(subgroupBallot(verdict == kOutside));
  const uint noSample = subgroupBallotBitCount(subgroupBallot(verdict == kNoSample));
  const uint transparent = subgroupBallotBitCount(subgroupBallot(verdict == kTransparent));
  if (subgroupElect()) {
    if (outside > 0) atomicAdd(counters.outside, outside);
    if (noSample > 0) atomicAdd(counters.noSample, noSample);
    if (transparent > 0) atomicAdd(counters.transparent, transparent);
  }
}
