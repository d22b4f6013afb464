// A ray's segment inside one cell as a node in its pixel's list, to be composited with others of the same pixel later.
//
// Before including: include/fan_segment.glsl; PIXEL_HEADS, PIXEL_LINKS, PIXEL_RANKS, PIXEL_COLORS, PIXEL_COUNTS are binding numbers;
// `CellPush push`.
#include "include/pixel_lists.glsl"

layout(binding = PIXEL_COLORS, scalar) buffer PixelColors { vec4 pixelColors[]; };
layout(binding = PIXEL_COUNTS, scalar) buffer PixelCounts { uint pixelCounts[]; };

// 0: lists are sorted by depth; otherwise by drawing order, for a k-buffer.
layout(constant_id = SPEC_KBUFFER) const uint kBuffer = 0;

void main() {
  const vec2 screen = screenOf(gl_FragCoord, push.scale);
  const Segment segment = fragmentSegment(screen);
  const vec4 color = fragmentColor(segment, screen);
  if (color == vec4(0.0)) return;  // nothing to composite
  const uint node = atomicAdd(pixelCounts[push.band.index], 1u);
  if (node >= push.band.capacity) return;
  // Cells may overlap: a ray goes through them in the order of its segments' middles.
  const uint middle = orderedFloat(segment.depthFront + 0.5 * segment.thickness);
  const uint slot = push.firstSlot + uint(fanSlot());
  pixelRanks[node] = kBuffer == 0u ? uvec2(middle, slot) : uvec2(slot, middle);
  pixelColors[node] = color;
  const uvec2 pixel = uvec2(gl_FragCoord.xy);
  pixelLinks[node] = atomicExchange(pixelHeads[(pixel.y - push.band.firstRow) * push.band.width + pixel.x], node);
}
