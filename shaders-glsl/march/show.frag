// What march.comp made of a pixel.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/pixel_lists.h"

layout(binding = 0) uniform samplerBuffer colors;

layout(push_constant, scalar) uniform Push { PixelBand band; };

layout(location = 0) out vec4 color;

void main() {
  const uvec2 pixel = uvec2(gl_FragCoord.xy);
  color = texelFetch(colors, int((pixel.y - band.firstRow) * band.width + pixel.x));
}
