// A ray's segment inside one cell as a node in its pixel's list, to be composited with others of the same pixel later.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/limits.h"
#include "shared/clipped_cells.h"
#include "shared/pixel_lists.h"
#include "shared/raster_push.h"
#include "shared/spec_ids.h"

#define CELL_PLANES 1
#define TRANSFER_PIECES 2
#define TRANSFER_PIECE_BINS 3
#define INTEGRATION_NUMBERS 4
#define INTEGRATION_TABLE_2D 5
#define INTEGRATION_TABLE_3D 6
#include "include/fan_segment.glsl"
#define PIXEL_HEADS 7
#define PIXEL_LINKS 8
#define PIXEL_RANKS 9
#include "include/pixel_lists.glsl"
layout(binding = 10, scalar) buffer PixelColors { vec4 pixelColors[]; };
layout(binding = 11, scalar) buffer PixelCounts { uint pixelCounts[]; };

// 0: lists are sorted by depth; otherwise by drawing order, for a k-buffer.
layout(constant_id = SPEC_KBUFFER) const uint kBuffer = 0;

layout(push_constant, scalar) uniform Push {
  RasterPush push;
  PixelBand band;
  uint firstSlot;  // of the batch
};

void main() {
  const vec2 screen = screenOf(gl_FragCoord, push);
  const Segment segment = fragmentSegment(screen);
  const vec4 color = fragmentColor(segment, screen);
  if (color == vec4(0.0)) return;  // nothing to composite
  const uint node = atomicAdd(pixelCounts[band.index], 1u);
  if (node >= band.capacity) return;
  // Cells may overlap: a ray goes through them in the order of its segments' middles.
  const uint middle = orderedFloat(segment.depthFront + 0.5 * segment.thickness);
  const uint slot = firstSlot + uint(fanCell >> 1);
  pixelRanks[node] = kBuffer == 0u ? uvec2(middle, slot) : uvec2(slot, middle);
  pixelColors[node] = color;
  const uvec2 pixel = uvec2(gl_FragCoord.xy);
  pixelLinks[node] = atomicExchange(pixelHeads[(pixel.y - band.firstRow) * band.width + pixel.x], node);
}
