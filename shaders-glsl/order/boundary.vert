// A corner of a boundary face, for lists of where rays enter and leave the mesh.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/frame_view.h"
#include "shared/limits.h"
#include "shared/clipped_cells.h"
#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"

#include "include/view_space.glsl"

layout(constant_id = SPEC_WIDE_ADDRESSING) const bool kWideAddressing = false;

layout(binding = 0, scalar) uniform FrameViewBlock { FrameView view; };
layout(binding = 1) uniform samplerBuffer meshVertices;
layout(binding = 2) uniform usamplerBuffer boundaryVertices;  // three per face
layout(binding = 3) uniform usamplerBuffer boundaryCells;
layout(binding = 4) uniform usamplerBuffer keys;

layout(buffer_reference, scalar, buffer_reference_align = 16) readonly buffer VerticesAt { vec4 data[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer UintsAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  VerticesAt verticesAt;
  UintsAt boundaryVerticesAt;
  UintsAt boundaryCellsAt;
  UintsAt keysAt;
  PixelBand band;
};

layout(location = 0) out float depth;
layout(location = 1) flat out uint cell;

void main() {
  const uint face = gl_VertexIndex / 3u;
  cell = kWideAddressing ? boundaryCellsAt.data[face] : texelFetch(boundaryCells, int(face)).x;
  const uint key = kWideAddressing ? keysAt.data[cell] : texelFetch(keys, int(cell)).x;
  depth = 0.0;
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // a cell that no ray meets: beside the picture
  if (key != KEY_OUTSIDE) {
    const uint vertex =
        kWideAddressing ? boundaryVerticesAt.data[gl_VertexIndex] : texelFetch(boundaryVertices, gl_VertexIndex).x;
    const vec3 position =
        viewPosition(view, (kWideAddressing ? verticesAt.data[vertex] : texelFetch(meshVertices, int(vertex))).xyz);
    const vec2 ndcPerUnit = view.pixelsPerUnit / view.halfSize;
    depth = position.z;
    // Rays start at the eye or its plane. Under perspective the clipper's z >= 0 is depth >= 1e-12; otherwise depth is scaled
    // so that the whole mesh, within 1.8 of its centre, ends before z = w.
    gl_Position = kPerspective ? vec4(position.xy * ndcPerUnit, depth - 1e-12, depth)
                               : vec4(position.xy * ndcPerUnit, depth / (abs(view.viewFromMesh[2].w) + 1.8), 1.0);
  }
}
