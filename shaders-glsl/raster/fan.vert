// One vertex of a projected cell's fan.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"

layout(location = 0) in vec2 position;  // ndc
layout(location = 1) in vec4 ends;      // see project/project.comp

layout(binding = 0) uniform usamplerBuffer cellModes;

layout(location = 0) out vec4 fanEnds;
layout(location = 1) flat out vec2 thickEnds;  // x and z of the triangle's first vertex, which is the fan's centre
layout(location = 2) flat out int fanCell;     // slot in the batch, doubled; odd for a cell that is clipped

void main() {
  gl_Position = vec4(position, 0.0, 1.0);
  fanEnds = ends;
  thickEnds = ends.xz;
  const int slot = gl_VertexIndex / int(FAN_VERTICES);
  fanCell = slot * 2 + int(texelFetch(cellModes, slot).x);
}
