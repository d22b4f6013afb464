// One vertex of a projected cell's fan.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/cell_push.h"
#include "shared/spec_ids.h"

layout(constant_id = SPEC_PERSPECTIVE) const bool kPerspective = true;

layout(location = 0) in vec2 position;  // ndc
layout(location = 1) in vec4 ends;      // see include/project_cell.glsl

layout(binding = 0) uniform usamplerBuffer cellModes;

layout(push_constant, scalar) uniform Push { CellPush push; };

#define TRANSFER_PIECES 2
#define TRANSFER_PIECE_BINS 3
#include "include/fan_vertex.glsl"

void main() {
  const int slot = gl_VertexIndex / int(FAN_VERTICES);
  handOnVertex(position, ends, slot, texelFetch(cellModes, slot).x != 0u);
}
