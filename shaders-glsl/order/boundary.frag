// A ray enters or leaves the mesh: a node in its pixel's list, exits before entries, near ones before far ones.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_buffer_reference : require

#include "shared/pixel_lists.h"
#include "shared/visibility.h"

#define PIXEL_HEADS 5
#define PIXEL_LINKS 6
#define PIXEL_RANKS 7
#include "include/pixel_lists.glsl"
layout(binding = 8, scalar) buffer PixelCounts { uint pixelCounts[]; };

layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer UintsAt { uint data[]; };
layout(push_constant, scalar) uniform Push {
  UintsAt addresses[4];  // the vertex shader's
  PixelBand band;
};

layout(location = 0) in float depth;
layout(location = 1) flat in uint cell;

void main() {
  const uint node = atomicAdd(pixelCounts[band.index], 1u);
  if (node >= band.capacity) return;
  const uvec2 pixel = uvec2(gl_FragCoord.xy);
  // Faces are oriented outwards: those that face the eye are entered.
  const uint entry = gl_FrontFacing ? ENTRY_BIT : 0u;
  pixelRanks[node] = uvec2((floatBitsToUint(max(depth, 0.0)) & ~ENTRY_BIT) | entry, cell);
  pixelLinks[node] = atomicExchange(pixelHeads[(pixel.y - band.firstRow) * band.width + pixel.x], node);
}
