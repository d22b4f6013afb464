// Rays walk through the mesh from the front and gather light.
//
// One invocation per pixel; its list holds the faces where its ray enters the mesh, near ones first. A walk ends where the ray
// leaves the mesh, or where nothing behind can be seen any more. Where layers of the mesh overlap, it is also left where the middle of
// its next segment lies behind the next entry in the list, and waits there with that middle as its rank: so segments are composited in
// the order of their middles. (An entry lies before its segment's middle; found to be too near, it goes back into the list itself.)
// After kRounds rounds the face at which the ray stands takes the place of its entry, the pixel is counted, and another dispatch goes on.
//
// With exact integration, a round of the loop is one part of a cell's segment (include/integration/ray_parts.glsl), most cells have
// one: a loop over parts within a loop over cells would keep all lanes of a subgroup waiting for the one with most parts. With
// another method a round is a cell. After a turn of kTurnRounds, rays that have come to a walk's end begin the next one while others go
// on with theirs.
//
// Included by march/march.comp in single, by march/march_precise.comp in double precision (include/real.glsl), and with methods
// other than exact integration by march/march_methods.comp and march/march_methods_precise.comp.
#include "include/march/march_bindings.glsl"

// Scalar and optics are carried from cell to cell. A field of one scalar per cell jumps there.
const bool kIsCarried = kIntegration == INTEGRATION_EXACT && !kCellField;

const uint kRounds = kIntegration == INTEGRATION_EXACT ? MARCH_ROUNDS : MARCH_CELLS;

struct Segment {
  float front, back;  // scalars
  float thickness;    // mesh units
  uint rank;          // of its middle, among all segments on the ray
};

// The segment between two faces; what lies behind the eye is cut off.
Segment cellSegment(Ray ray, uint cell, Place enter, Place leave) {
  Segment segment = Segment(enter.scalar, leave.scalar, float(leave.depth - enter.depth), 0u);
  if (kCellField) segment.front = segment.back = loadCellScalar(mesh, cell);
  if (kNearCells) {
    const float hidden = clamp(float(ray.eyeDepth - enter.depth) / max(segment.thickness, 1e-30), 0.0, 1.0);
    segment.front = mix(segment.front, segment.back, hidden);
    segment.thickness *= 1.0 - hidden;
  }
  segment.rank = depthRank(leave.depth - 0.5 * segment.thickness) | ENTRY_BIT;
  segment.thickness *= ray.lengthPerDepth;
  return segment;
}

// Composites the next part of a cell's segment, or all of it. Returns whether the segment is through.
bool gather(inout PartWalk parts, inout vec3 light, inout float opacity, inout float clearness) {
  if (kIntegration == INTEGRATION_EXACT) return walkPart(parts, light, opacity, clearness);
  const vec4 color = integrateSegment(parts.front, parts.back, parts.thickness);
  const float transmittance = kEmissionPerLength ? clearness : 1.0 - opacity;
  light += transmittance * color.rgb;
  clearness *= 1.0 - color.a;
  opacity += (1.0 - opacity) * color.a;
  return true;
}

#include "include/march/march_pixel_lists.glsl"

void main() {
  const uvec2 place = tilePixel(band);
  if (place.x >= band.width || place.y >= band.rowCount) return;
  const uint pixel = place.y * band.width + place.x;
  uint node = pixelHeads[pixel];
  if (node == NO_NODE) return;
  const Ray ray = pixelRay(view, uvec2(place.x, band.firstRow + place.y));
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
  Segment segment;
  RayParts carried;
  PartWalk parts;
  bool isOvertaken = false;
  for (uint walk = 0; walk < kRounds; walk++) {
    if (!isWalking) {
      const uint code = pixelRanks[node].y;
      nextRank = rankOf(pixelLinks[node]);
      face = loadFace(mesh, restsAt, ray, code);
      next = behindFace(mesh, code);
      at = next;
      enter = meetFirst(face);
      crossCell(mesh, restsAt, acrossAt, ray, next, face);
      countCell();
      leave = meetNext(face, enter);
      segment = cellSegment(ray, at.cell, enter, leave);
      if (kIsCarried)
        carried = beginRay(segment.front, segment.back, segment.thickness);
      else
        parts = beginParts(segment.front, segment.back, segment.thickness);
      isOvertaken = segment.rank > nextRank;
      isWalking = true;
    }
    bool isThrough = false;
    bool isPaused = false;
    const uint turn = walk + 1u < kRounds ? kTurnRounds : MARCH_LAST_ROUND;  // the last one leaves no walk half done
    for (uint round = 0; round < turn; round++) {
      if (isOvertaken) break;
      // Of what lies in front of this part: its own opacity comes too late to be waited for.
      const bool isOpaque = isWalkOpaque(color.a, clearness);
      const bool isLast = kIsCarried ? walkRayPart(carried, color.rgb, color.a, clearness)
                                     : gather(parts, color.rgb, color.a, clearness);
      rounds++;
      isThrough = (isLast && next.cell == NO_CELL) || isOpaque;
      isPaused = isLast && rounds >= kRounds;
      if (isThrough || isPaused) break;
      if (isLast) {
        at = next;
        enter = leave;
        crossCell(mesh, restsAt, acrossAt, ray, next, face);
        countCell();
        leave = meetNext(face, enter);
        segment = cellSegment(ray, at.cell, enter, leave);
        isOvertaken = segment.rank > nextRank;
        if (kIsCarried) {
          carried.back = segment.back;
          carried.thickness = segment.thickness;
        } else {
          parts = beginParts(segment.front, segment.back, segment.thickness);
        }
      }
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
    if (node == NO_NODE || isPaused || (!isWalking && rounds >= kRounds)) break;
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
