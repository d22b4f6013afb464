// Finds the cell in which a ray starts: walks from an exit towards the eye and a step beyond, and the face there takes the exit's
// place in the list. An exit from which the walk comes to an entry first is dropped, the next one is tried: exits of layers that
// overlap can be anywhere. Rays that are not through after MARCH_ROUNDS cells are counted, and go on in another dispatch.
//
// Included by march/seek.comp in single, by march/seek_precise.comp in double precision (include/real.glsl).
#include "shared/clipped_cells.h"
#include "shared/frame_view.h"
#include "shared/march.h"
#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"
#include "shared/visibility.h"

layout(local_size_x = MARCH_WORKGROUP) in;

#define MESH_CELLS 1
#define MESH_VERTICES 2
#define MESH_CELL_SCALARS 3
#define TOPOLOGY_ACROSS 4
#define MESH_VERTEX_RESTS 10
#define MARCH_TILES 9
#include "include/dispatch.glsl"
#include "include/march_pixel.glsl"
#include "include/mesh_access.glsl"
#include "include/real.glsl"
#include "include/view_space.glsl"
#include "include/ray_walk.glsl"

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
#define PIXEL_HEADS 5
#define PIXEL_LINKS 6
#define PIXEL_RANKS 7
#include "include/pixel_lists.glsl"
layout(binding = 8, scalar) buffer Counts { MarchCounts counts; };

layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  VertexRestsAt restsAt;
  AcrossAt acrossAt;
  PixelBand band;
};

const float kSlack = 4e-6;  // some roundings of a depth

struct Start {
  uint code;      // face behind which the ray starts, or where the walk stands
  bool isFound;
  bool isOutside;  // there was an entry on the way
};

// Walks from an exit towards the eye.
Start seekStart(Ray ray, uint code, inout uint rounds) {
  Start start = Start(code, false, false);
  Behind next = behindFace(mesh, code);
  uint cell = next.cell;
  uint opposite = 0;
  Face face = loadFace(mesh, restsAt, ray, code);
  for (uint i = 0; i < MARCH_ROUNDS; i++) {
    opposite = crossCell(mesh, restsAt, acrossAt, ray, next, face);
    rounds++;
    // An entry that rounding put behind the eye is not in the list; here it may come out before it.
    const real depth = meetFirst(face).depth;
    start.isFound = depth <= (next.cell == NO_CELL ? ray.eyeDepth + kSlack : ray.eyeDepth);
    start.isOutside = !start.isFound && next.cell == NO_CELL;
    if (start.isFound || start.isOutside) break;
    cell = next.cell;
    if (rounds >= MARCH_ROUNDS) break;
  }
  // Found: a face of the cell that was crossed. On the way: the same face, as one of the cell that comes next.
  start.code = cellFace(mesh, cell, start.isFound || start.isOutside ? opposite : next.vertex);
  return start;
}

void main() {
  const uvec2 place = tilePixel(band);
  if (place.x >= band.width || place.y >= band.rowCount) return;
  const uint pixel = place.y * band.width + place.x;
  uint node = pixelHeads[pixel];
  const Ray ray = pixelRay(view, uvec2(place.x, band.firstRow + place.y));
  uint last = NO_NODE;  // node that stays before this one
  uint rounds = 0;
  // Ranks: ENTRY_BIT alone is a start that was found; with more bits it is an entry, and the exits end there; otherwise it is the
  // number of starts still to be found from this exit on.
  for (uint i = 0; i < kLongestList; i++) {
    if (node == NO_NODE || rounds >= MARCH_ROUNDS) break;
    const uint rank = pixelRanks[node].x;
    if (rank > ENTRY_BIT) break;
    const uint next = pixelLinks[node];
    Start start = Start(0u, rank == ENTRY_BIT, rank == 0u);
    if (!start.isFound && !start.isOutside) {
      start = seekStart(ray, pixelRanks[node].y, rounds);
      pixelRanks[node] = uvec2(start.isFound ? ENTRY_BIT : rank, start.code);
      if (!start.isFound && !start.isOutside) break;
    }
    if (rank != ENTRY_BIT && next != NO_NODE && pixelRanks[next].x < ENTRY_BIT)
      pixelRanks[next].x = rank - (start.isFound && rank > 0u ? 1u : 0u);
    if (start.isFound)
      last = node;
    else if (last == NO_NODE)
      pixelHeads[pixel] = next;
    else
      pixelLinks[last] = next;
    node = next;
  }
  if (node != NO_NODE && pixelRanks[node].x < ENTRY_BIT) atomicAdd(counts.unfinished, 1u);
}
