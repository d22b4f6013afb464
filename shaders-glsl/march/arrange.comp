// Puts every pixel's list of faces into the order of the walk.
//
// Without an eye inside the mesh the list holds entries only. Otherwise a ray meets one exit more than entries if it starts inside
// the mesh (or several where the mesh overlaps itself). Then the exits stay in the list, in front, and seek.comp walks back from
// them.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require

#include "shared/march.h"
#include "shared/pixel_lists.h"
#include "shared/spec_ids.h"
#include "shared/visibility.h"

layout(local_size_x = MARCH_WORKGROUP) in;

layout(constant_id = SPEC_NEAR_CELLS) const bool kNearCells = false;

#define MARCH_TILES 3
#include "include/dispatch.glsl"
#include "include/march_pixel.glsl"
#define PIXEL_HEADS 0
#define PIXEL_LINKS 1
#define PIXEL_RANKS 2
#include "include/pixel_lists.glsl"

layout(push_constant, scalar) uniform Push { PixelBand band; };

bool isExit(uint node) { return node != NO_NODE && (pixelRanks[node].x & ENTRY_BIT) == 0u; }

// Of a sorted list: without the exits if each has its entry; otherwise the first one's rank becomes the number of those
// that have none.
uint countedExits(uint head) {
  uint exits = 0;
  uint entries = 0;
  uint firstEntry = NO_NODE;
  uint node = head;
  for (uint i = 0; i < kLongestList; i++) {
    if (node == NO_NODE) break;
    if (isExit(node)) {
      exits++;
    } else {
      if (entries == 0u) firstEntry = node;
      entries++;
    }
    node = pixelLinks[node];
  }
  if (exits <= entries) return firstEntry;
  pixelRanks[head].x = exits - entries;
  return head;
}

void main() {
  const uvec2 place = tilePixel(band);
  if (place.x >= band.width || place.y >= band.rowCount) return;
  const uint pixel = place.y * band.width + place.x;
  uint head = pixelHeads[pixel];
  if (head == NO_NODE) return;
  if (pixelLinks[head] == NO_NODE && !kNearCells) return;
  head = sortedShortList(head);
  if (kNearCells) head = countedExits(head);
  pixelHeads[pixel] = head;
}
