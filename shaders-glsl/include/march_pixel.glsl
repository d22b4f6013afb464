// Which pixel an invocation works on: workgroups are tiles of MARCH_TILE squared, eight invocations in a row are 4 x 2 pixels of
// one, so that rays that run together take the same way.
//
// Before including: dispatch.glsl, shared/march.h, shared/pixel_lists.h.

// Column, and row within the band.
uvec2 tilePixel(PixelBand band) {
  const uint tiles = (band.width + MARCH_TILE - 1u) / MARCH_TILE;
  const uint tile = workgroupIndex();
  const uint i = gl_LocalInvocationIndex;
  const uvec2 inside = uvec2((i & 3u) | ((i >> 1) & 4u), ((i >> 2) & 1u) | ((i >> 3) & 6u));
  return uvec2(tile % tiles, tile / tiles) * MARCH_TILE + inside;
}
