// What resolve.comp made of a pixel's list, to be blended over what lies behind.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"
#include "shared/target_output.h"

#include "include/target_output.glsl"

layout(binding = 0, scalar) readonly buffer PixelHeads { uint pixelHeads[]; };
layout(binding = 1, scalar) readonly buffer PixelColors { vec4 pixelColors[]; };

layout(push_constant, scalar) uniform Push { PixelBand band; };

layout(location = 0) out vec4 color;

void main() {
  const uvec2 pixel = uvec2(gl_FragCoord.xy);
  const uint head = pixelHeads[(pixel.y - band.firstRow) * band.width + pixel.x];
  color = vec4(0.0);
  if (head != NO_NODE) color = targetOutput(pixelColors[head], pixel, NO_NODE);
}
