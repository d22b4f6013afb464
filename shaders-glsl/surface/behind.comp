// Composites opaque surfaces behind what rays have gathered in front of them.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/appearance.h"
#include "shared/pixel_lists.h"

layout(local_size_x = 64) in;

#include "include/dispatch.glsl"

layout(binding = 0) uniform samplerBuffer rayEnds;  // surface/shade.comp
layout(binding = 1, scalar) buffer Colors { vec4 colors[]; };

layout(push_constant, scalar) uniform Push { PixelBand band; };

void main() {
  const uint pixel = linearIndex();
  if (pixel >= band.width * band.rowCount) return;
  const vec4 end = texelFetch(rayEnds, int(pixel));
  if (end.w == NO_RAY_END) return;
  const vec4 color = colors[pixel];
  colors[pixel] = vec4(color.rgb + (1.0 - color.a) * end.rgb, 1.0);
}
