// Rays walk as in march.glsl, with all that is shown beside the volume: isosurfaces, other classification, clip planes, opaque surfaces
// (docs/appearance.md). A frame without any of it runs march.glsl, which has never heard of them.
//
// A ray that comes to an isosurface leaves the loop over parts: on processors an untaken branch costs what a taken one does, so the
// surface is shaded outside of it, once for all rays of a subgroup that have come to their next one.
//
// Included by march/march_appearance.comp in single, by march/march_appearance_precise.comp in double precision.
#define APPEARANCE
#include "include/march/march_bindings.glsl"
#include "include/march/march_pixel_lists.glsl"
#include "include/march/appearance_texels.glsl"
#include "include/march/illumination.glsl"
#include "include/march/ray_direction.glsl"
#include "include/march/visible_range.glsl"
#include "include/march/isosurface.glsl"
#include "include/march/classification.glsl"
#include "include/march/visible_segment.glsl"

// The face through which a ray has entered a cell.
Face enteredFace(MeshAddresses mesh, VertexRestsAt restsAt, Ray ray, Behind at) {
  return loadFace(mesh, restsAt, ray, cellFace(mesh, at.cell, at.vertex));
}

void main() {
  const uvec2 place = tilePixel(band);
  if (place.x >= band.width || place.y >= band.rowCount) return;
  const uint pixel = place.y * band.width + place.x;
  uint node = pixelHeads[pixel];
  if (node == NO_NODE) return;
  const uvec2 picturePlace = uvec2(place.x, band.firstRow + place.y);
  const Ray ray = pixelRay(view, picturePlace);
  const VisibleRange range = visibleRange(view, ray, picturePlace, pixel);
  const vec3 toEye = directionToEye(view, picturePlace);
  vec4 color = colors[pixel];
  float clearness = 1.0;
  if (kEmissionPerLength) {
    if (color.a < 0.0) clearness = -color.a;
    color.a = 1.0 - clearness;
  }
  uint rounds = 0;
  bool isWalking = false;
  uint nextRank = 0u;
  Face face;
  Behind next, at;
  Place enter, leave;
  VisibleSegment segment;
  RayParts parts;
  Attributes enterAttributes, leaveAttributes;
  ClassifiedWalk classified;
  bool isOvertaken = false;
  for (uint walk = 0; walk < MARCH_ROUNDS; walk++) {
    if (!isWalking) {
      const uint code = pixelRanks[node].y;
      nextRank = rankOf(pixelLinks[node]);
      face = loadFace(mesh, restsAt, ray, code);
      next = behindFace(mesh, code);
      at = next;
      enter = meetFirst(face);
      if (kClassified) enterAttributes = faceAttributes(face);
      crossCell(mesh, restsAt, acrossAt, ray, next, face);
      countCell();
      leave = meetNext(face, enter);
      segment = visibleSegment(mesh, ray, range, at.cell, enter, leave);
      parts = beginRay(segment.front, segment.back, segment.thickness);
      if (kClassified) {
        leaveAttributes = faceAttributes(face);
        classified = beginClassified(segment, enterAttributes, leaveAttributes, toEye);
      }
      isOvertaken = segment.rank > nextRank;
      isWalking = true;
    }
    bool isThrough = false;
    bool isPaused = false;
    const uint turn = walk + 1u < MARCH_ROUNDS ? kTurnRounds : MARCH_LAST_ROUND;  // the last one leaves no walk half done
    for (uint surfaceRound = 0; surfaceRound < MARCH_LAST_ROUND; surfaceRound++) {
      bool isAtSurface = false;
      for (uint round = 0; round < turn; round++) {
        if (isOvertaken) break;
        // Of what lies in front of this part: its own opacity comes too late to be waited for.
        const bool isOpaque = isWalkOpaque(color.a, clearness);
        bool isLast = true;
        parts.surface = -1.0;
        if (segment.isVisible)
          isLast = kClassified ? walkClassifiedPart(classified, parts, color.rgb, color.a, clearness)
                               : walkRayPart(parts, color.rgb, color.a, clearness);
        rounds++;
        isThrough = (isLast && (next.cell == NO_CELL || leave.depth >= range.end)) || isOpaque;
        isAtSurface = kIsosurfaces && parts.surface >= 0.0;
        isPaused = isLast && rounds >= MARCH_ROUNDS;
        if (isThrough || isAtSurface || isPaused) break;
        if (isLast) {
          at = next;
          enter = leave;
          crossCell(mesh, restsAt, acrossAt, ray, next, face);
          countCell();
          leave = meetNext(face, enter);
          const bool wasVisible = segment.isVisible;
          segment = visibleSegment(mesh, ray, range, at.cell, enter, leave);
          isOvertaken = segment.rank > nextRank;
          if (kCellField || ((kClipPlanes > 0u || kNearCells) && !wasVisible))
            parts = beginRay(segment.front, segment.back, segment.thickness);
          parts.back = segment.back;
          parts.thickness = segment.thickness;
          if (kClassified) {
            enterAttributes = leaveAttributes;
            leaveAttributes = faceAttributes(face);
            // Where nothing cuts segments, one begins with what the last one ended with.
            const bool isWhole = kClipPlanes == 0u && !kRayEnds && !kNearCells;
            const SegmentEnd last = classified.back;
            classified = beginClassified(segment, enterAttributes, leaveAttributes, toEye);
            if (isWhole) classified.front = last;
          }
        }
      }
      if (!kIsosurfaces) break;
      if (isThrough || !isAtSurface) break;
      const float share = clamp((parts.scalar - enter.scalar) / (leave.scalar - enter.scalar), 0.0, 1.0);
      addSurface(int(parts.surface), parts.rising, mesh, at.cell, enteredFace(mesh, restsAt, ray, at), face, share, toEye, color.rgb,
                 color.a, clearness);
      isThrough = isWalkOpaque(color.a, clearness);
      if (isThrough) break;
    }
    if (isThrough) {
      node = isWalkOpaque(color.a, clearness) ? NO_NODE : pixelLinks[node];
      isWalking = false;
    } else if (isOvertaken) {
      // Layers overlap: a segment of another one comes first.
      pixelRanks[node] = uvec2(segment.rank, cellFace(mesh, at.cell, at.vertex));
      node = putBack(node);
      isWalking = false;
    } else if (isPaused) {
      pixelRanks[node].y = cellFace(mesh, next.cell, next.vertex);
    }
    if (node == NO_NODE || isPaused || (!isWalking && rounds >= MARCH_ROUNDS)) break;
  }
  if (kEmissionPerLength && node != NO_NODE) color.a = -clearness;  // kept with all its digits for the next dispatch
  colors[pixel] = color;
  pixelHeads[pixel] = node;
  if (node != NO_NODE) atomicAdd(counts.unfinished, 1u);
  if (kCountWork) {
    ADD_WITH_CARRY(counts.cellsLow, counts.cellsHigh, cellSteps);
    ADD_WITH_CARRY(counts.partsLow, counts.partsHigh, rounds);
  }
}
