// Where rays enter the mesh (and, when the eye may be inside it, leave it): a node in the pixel's list.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/clipped_cells.h"
#include "shared/frame_view.h"
#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"
#include "shared/visibility.h"

#define MESH_CELLS 1
#define MESH_VERTICES 2
#define MESH_CELL_SCALARS 3
#define TOPOLOGY_NEIGHBORS 5
#include "include/mesh_access.glsl"
#include "include/view_space.glsl"
#include "include/ray_walk.glsl"

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
layout(binding = 4) uniform usamplerBuffer boundaryVertices;  // three per face, (b - a) x (c - a) points outwards
layout(binding = 6) uniform usamplerBuffer boundaryCells;
#define PIXEL_HEADS 7
#define PIXEL_LINKS 8
#define PIXEL_RANKS 9
#include "include/pixel_lists.glsl"
layout(binding = 10, scalar) buffer PixelCounts { uint pixelCounts[]; };

layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer UintsAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  UintsAt boundaryVerticesAt;
  UintsAt boundaryCellsAt;
  PixelBand band;
};

layout(location = 0) flat in uint boundaryFace;

uint boundaryVertex(uint i) {
  return kWideAddressing ? boundaryVerticesAt.data[i] : texelFetch(boundaryVertices, int(i)).x;
}

void main() {
  const uvec2 pixel = uvec2(gl_FragCoord.xy);
  const Ray ray = pixelRay(view, pixel);
  const Corner a = loadCorner(mesh, ray, boundaryVertex(3u * boundaryFace));
  const Corner b = loadCorner(mesh, ray, boundaryVertex(3u * boundaryFace + 1u));
  const Corner c = loadCorner(mesh, ray, boundaryVertex(3u * boundaryFace + 2u));
  const bool leftAB = isLeft(a, b);
  // The outside is in front: the ray enters where it sees the corners anticlockwise.
  if (leftAB != isLeft(b, c) || leftAB != isLeft(c, a) || (!leftAB && !kNearCells)) return;
  Face face = Face(a, b, c);
  if (!leftAB) face = Face(a, c, b);
  const Meeting there = meeting(face);
  const float depth = there.there.x;
  if (there.area == 0.0 || (kNearCells && depth < ray.eyeDepth)) return;

  const uint node = atomicAdd(pixelCounts[band.index], 1u);
  if (node >= band.capacity) return;
  const uint cell = kWideAddressing ? boundaryCellsAt.data[boundaryFace] : texelFetch(boundaryCells, int(boundaryFace)).x;
  const uvec4 vertices = loadCellVertices(mesh, cell);
  // Depths are within 1.8 of the mesh's centre: what is sorted by is positive.
  const uint rank = (floatBitsToUint(depth + 4.0) & ~ENTRY_BIT) | (leftAB ? ENTRY_BIT : 0u);
  pixelRanks[node] = uvec2(rank, cellFace(cell, vertices, oppositeVertex(vertices, face)));
  pixelLinks[node] = atomicExchange(pixelHeads[(pixel.y - band.firstRow) * band.width + pixel.x], node);
}
