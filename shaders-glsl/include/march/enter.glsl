// Where rays enter the mesh (and, when the eye may be inside it, leave it): a node in the pixel's list. A job of bin.comp, a face in a
// tile, is done by kJobLanes invocations, which take its pixels in turn.
//
// Included by march/enter.comp in single, by march/enter_precise.comp in double precision (include/real.glsl).
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
#define TOPOLOGY_ACROSS 5
#define MESH_VERTEX_RESTS 14
#define MARCH_TILES 11
#include "include/dispatch.glsl"
#include "include/march/count_work.glsl"
#include "include/march_pixel.glsl"
#include "include/mesh_access.glsl"
#include "include/real.glsl"
#include "include/view_space.glsl"
#include "include/ray_walk.glsl"

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
layout(binding = 4) uniform usamplerBuffer boundary;  // as in bin.comp
#define PIXEL_HEADS 6
#define PIXEL_LINKS 7
#define PIXEL_RANKS 8
#include "include/pixel_lists.glsl"
layout(binding = 9) uniform usamplerBuffer jobs;
layout(binding = 10, scalar) buffer TileMarks { uint tileMarks[]; };  // bit 1: is in sortTiles
layout(binding = 12, scalar) writeonly buffer SortTiles { uint sortTiles[]; };
layout(binding = 13, scalar) buffer Counts { MarchCounts counts; };

layout(constant_id = SPEC_JOB_LANES) const uint kJobLanes = 1;

layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer FacesAt { uvec4 data[]; };
layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  VertexRestsAt restsAt;
  FacesAt boundaryAt;
  PixelBand band;
  uint jobCapacity;
};

void addNode(uint node, uint tile, uvec2 place, uint rank, uint code) {
  pixelRanks[node] = uvec2(rank, code);
  const uint behind = atomicExchange(pixelHeads[place.y * band.width + place.x], node);
  pixelLinks[node] = behind;
  if (behind != NO_NODE && (atomicOr(tileMarks[tile], 2u) & 2u) == 0u) sortTiles[atomicAdd(counts.sortTiles, 1u)] = tile;
}

void main() {
  const uint index = dealtIndex();
  if (index / kJobLanes >= min(counts.jobs, jobCapacity)) return;
  const uvec3 job = texelFetch(jobs, int(index / kJobLanes)).xyz;
  const uint tile = job.y >> MARCH_JOB_PLACE_BITS;
  const uvec2 origin = tileOrigin(band, tile);
  const uvec2 first = uvec2(job.y & 7u, (job.y >> 3) & 7u);
  const uvec2 last = uvec2((job.y >> 6) & 7u, (job.y >> 9) & 7u);
  const uvec2 size = last - first + 1u;
  if (job.z > band.capacity || size.x * size.y > band.capacity - job.z) return;  // no room: the band will be done again
  const uvec4 entry = kWideAddressing ? boundaryAt.data[job.x] : texelFetch(boundary, int(job.x));
  const Vertex vertexA = loadWalkVertex(mesh, restsAt, entry.x);
  const Vertex vertexB = loadWalkVertex(mesh, restsAt, entry.y);
  const Vertex vertexC = loadWalkVertex(mesh, restsAt, entry.z);

  uint entries = 0;
  const uint pixels = size.x * size.y;
  const float rowsPerPixel = 1.0 / float(size.x);
  for (uint i = index % kJobLanes; i < MARCH_TILE * MARCH_TILE; i += kJobLanes) {
    const uint row = uint((float(i) + 0.5) * rowsPerPixel);
    const uvec2 place = origin + first + uvec2(i - row * size.x, row);
    const Ray ray = pixelRay(view, uvec2(place.x, band.firstRow + place.y));
    const Corner a = seenCorner(ray, vertexA);
    const Corner b = seenCorner(ray, vertexB);
    const Corner c = seenCorner(ray, vertexC);
    const bool leftAB = isLeft(a, b);
    // The outside is in front: the ray enters where it sees the corners anticlockwise.
    const bool isMet = leftAB == isLeft(b, c) && leftAB == isLeft(c, a) && (leftAB || kNearCells);
    Face face = Face(a, b, c);
    if (!leftAB) face = Face(a, c, b);
    const Meeting there = meeting(face);
    const real depth = there.there.depth;
    const uint rank = depthRank(depth) | (leftAB ? ENTRY_BIT : 0u);
    if (i < pixels && isMet && there.area != 0.0 && !(kNearCells && depth < ray.eyeDepth)) {
      addNode(job.z + i, tile, place, rank, entry.w);
      entries++;
    }
    if (i + kJobLanes >= pixels) break;
  }
  if (kCountWork) atomicAdd(counts.entries, entries);
}
