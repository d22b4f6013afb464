// Composites every pixel's list of segments; the result becomes the colour of the list's first node.
//
// Sorted by depth, front to back; or, as Callahan et al. 2005 do (HAVS), in drawing order through a buffer of the k nearest
// segments so far: what is pushed out is drawn, farthest first. Where a segment arrives too late for that, k was too small.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"

layout(local_size_x = 64) in;

#include "include/dispatch.glsl"
#define PIXEL_HEADS 0
#define PIXEL_LINKS 1
#define PIXEL_RANKS 2
#include "include/pixel_lists.glsl"
layout(binding = 3, scalar) buffer PixelColors { vec4 pixelColors[]; };
layout(binding = 4, scalar) buffer ShortPixels { uint shortPixels; };  // pixels where k was too small

layout(constant_id = SPEC_KBUFFER) const uint kBuffer = 0;

layout(push_constant, scalar) uniform Push { PixelBand band; };

vec4 frontToBack(uint node) {
  vec4 sum = vec4(0.0);
  for (uint i = 0; i < kLongestList; i++) {
    if (node == NO_NODE) break;
    sum += (1.0 - sum.a) * pixelColors[node];
    node = pixelLinks[node];
  }
  return sum;
}

uint buffered[KBUFFER_LARGEST];  // nodes, nearest first

vec4 throughKBuffer(uint node) {
  uint count = 0;
  uint drawnMiddle = 0xffffffffu;  // nearest of what was drawn
  bool isShort = false;
  vec4 sum = vec4(0.0);
  for (uint i = 0; i < kLongestList; i++) {
    if (node == NO_NODE && count == 0u) break;
    uint out_ = NO_NODE;
    if (node == NO_NODE) {
      count--;
      out_ = buffered[count];
    } else {
      const uint middle = pixelRanks[node].y;
      // Of equal ones the last to arrive is the nearest.
      uint place = 0;
      for (uint j = 0; j < kBuffer; j++) {
        if (j < count && pixelRanks[buffered[j]].y < middle) place = j + 1u;
      }
      if (count == kBuffer && place == count) {
        out_ = node;
      } else {
        if (count == kBuffer) out_ = buffered[count - 1u];
        count = min(count + 1u, kBuffer);
        for (uint j = kBuffer - 1u; j > 0u; j--) {
          if (j < count && j > place) buffered[j] = buffered[j - 1u];
        }
        buffered[place] = node;
      }
      node = pixelLinks[node];
    }
    if (out_ != NO_NODE) {
      const uint middle = pixelRanks[out_].y;
      isShort = isShort || middle > drawnMiddle;
      drawnMiddle = min(drawnMiddle, middle);
      const vec4 over = pixelColors[out_];
      sum = over + (1.0 - over.a) * sum;
    }
  }
  if (isShort) atomicAdd(shortPixels, 1u);
  return sum;
}

void main() {
  const uint pixel = linearIndex();
  if (pixel >= band.width * band.rowCount) return;
  const uint head = pixelHeads[pixel];
  if (head == NO_NODE) return;
  const uint first = sortedList(head);
  const vec4 color = kBuffer == 0u ? frontToBack(first) : throughKBuffer(first);
  pixelHeads[pixel] = first;
  pixelColors[first] = color;
}
