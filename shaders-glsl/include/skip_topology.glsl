// The whole mesh's topology, and a bit for every cell.
//
// Before including: mesh_access.glsl (for kWideAddressing); the push constants have `acrossAt`.
layout(binding = 0) uniform usamplerBuffer across;    // as in ray_walk.glsl
layout(binding = 1) uniform usamplerBuffer cellBits;
#include "include/across_pieces.glsl"

const uint NO_CELL = 0xffffffffu;

bool hasBit(uint cell) { return (texelFetch(cellBits, int(cell / 32u)).x >> cell % 32u & 1u) != 0u; }

uvec2 loadAcross(AcrossAt at, uint cell, uint k) {
  return kWideAddressing ? acrossPiece(at, cell).data[acrossPlace(at, cell) + k] : texelFetch(across, int(4u * cell + k)).xy;
}
