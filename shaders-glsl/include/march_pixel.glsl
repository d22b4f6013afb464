// Which pixel an invocation works on: workgroups are tiles of MARCH_TILE squared, eight invocations in a row are 4 x 2 pixels of
// one, so that rays that run together take the same way.
//
// Before including: dispatch.glsl, shared/march.h, shared/pixel_lists.h; MARCH_TILES is a binding number.
#include "include/dealt_workgroups.glsl"

layout(binding = MARCH_TILES, scalar) readonly buffer MarchTiles { uint marchTiles[]; };  // that have something to do

uint tileColumns(PixelBand band) { return (band.width + MARCH_TILE - 1u) / MARCH_TILE; }

// First pixel of a tile: column, and row within the band.
uvec2 tileOrigin(PixelBand band, uint tile) {
  const uint columns = tileColumns(band);
  return uvec2(tile % columns, tile / columns) * MARCH_TILE;
}

// Column, and row within the band.
uvec2 tilePixel(PixelBand band) {
  const uint i = gl_LocalInvocationIndex;
  const uvec2 inside = uvec2((i & 3u) | ((i >> 1) & 4u), ((i >> 2) & 1u) | ((i >> 3) & 6u));
  return tileOrigin(band, marchTiles[dealtWorkgroupIndex()]) + inside;
}
