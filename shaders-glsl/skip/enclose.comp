// Finds the surface around the cells that are kept. One invocation per cell. Run twice: the first time counts cells and faces; the
// second time writes a topology in which the other cells are not there, and lists its boundary faces.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "shared/skip.h"
#include "shared/spec_ids.h"

layout(local_size_x = SKIP_WORKGROUP) in;

#define MESH_CELLS 2
#define MESH_VERTICES 3
#define MESH_CELL_SCALARS 4
#include "include/dispatch.glsl"
#include "include/mesh_access.glsl"
#include "include/skip_topology.glsl"

layout(constant_id = SPEC_LIST_FACES) const bool kListFaces = false;

// A bit per cell: it lies on the positive side of its faces 1 and 3 (Adjacency::sides), and so on the other of 0 and 2.
layout(binding = 5) uniform usamplerBuffer windings;
layout(binding = 6, scalar) buffer Counts { SkipCounts counts; };

layout(buffer_reference, scalar, buffer_reference_align = 16) writeonly buffer FacesAt { uvec4 data[]; };
layout(push_constant, scalar) uniform Push {
  MeshAddresses mesh;
  AcrossAt acrossAt;
  AcrossAt keptAcrossAt;
  FacesAt facesAt;  // boundary faces, as in march/bin.comp
  uint cellCount;
};

// A cell's face k: its vertices so that (b - a) x (c - a) points out of the cell, and its code.
uvec4 outwardFace(uint cell, uint k) {
  const uvec4 vertices = loadCellVertices(mesh, cell);
  const uvec3 face = uvec3(vertices[k == 0u ? 1 : 0], vertices[k <= 1u ? 2 : 1], vertices[k <= 2u ? 3 : 2]);
  const bool isOddPositive = (texelFetch(windings, int(cell / 32u)).x >> cell % 32u & 1u) != 0u;
  const bool isPositive = isOddPositive == ((k & 1u) != 0u);
  return uvec4(isPositive ? face.xzy : face, 4u * cell + k);
}

void main() {
  const uint cell = linearIndex();
  const bool isKept = cell < cellCount && hasBit(min(cell, cellCount - 1u));
  uint faces = 0;
  if (cell < cellCount) {
    for (uint k = 0; k < 4u; k++) {
      const uvec2 next = loadAcross(acrossAt, cell, k);
      const bool isCut = next.x == NO_CELL || !hasBit(min(next.x, cellCount - 1u));
      if (isKept && isCut) {
        if (kListFaces) {
          facesAt.data[atomicAdd(counts.faces, 1u)] = outwardFace(cell, k);
          acrossPiece(keptAcrossAt, cell).data[acrossPlace(keptAcrossAt, cell) + k] = uvec2(NO_CELL, 0u);
        }
        faces++;
      }
    }
  }
  if (kListFaces) return;
  const uint cells = subgroupAdd(isKept ? 1u : 0u);
  const uint allFaces = subgroupAdd(faces);
  if (subgroupElect()) {
    if (cells > 0u) atomicAdd(counts.cells, cells);
    if (allFaces > 0u) atomicAdd(counts.faces, allFaces);
  }
}
