// The transfer function: its linear pieces, and what it says at one scalar.
//
// Before including: TRANSFER_PIECES and TRANSFER_PIECE_BINS are the binding numbers; shared/spec_ids.h.
#ifndef TETRALUX_INTEGRATION_TRANSFER_PIECES
#define TETRALUX_INTEGRATION_TRANSFER_PIECES

layout(constant_id = SPEC_EMISSION_PER_LENGTH) const bool kEmissionPerLength = false;

// Piece i is texels 3i to 3i+2:
//   x scalar at its low end, y at its high end, z extinction at the low end (1/mesh unit), w its slope
//   xyz luminance at the low end: L, or E (1/mesh unit) with emission per length
//   xyz its slope
// End pieces are constant and reach to -1e30 and 1e30.
layout(binding = TRANSFER_PIECES) uniform samplerBuffer transferPieces;
// Bin b covers scalars from -0.5 + b/TRANSFER_BINS to the next; texel 2b: the piece at its low end, 2b+1: at its high end.
layout(binding = TRANSFER_PIECE_BINS) uniform usamplerBuffer transferPieceBins;

// Luminance, as in the pieces, and extinction (1/mesh unit).
struct Optics {
  vec3 luminance;
  float extinction;
};

// Index of the piece that holds a scalar; on a control point, the piece after it.
int pieceOf(float scalar) {
  const int bin = clamp(int((scalar + 0.5) * float(TRANSFER_BINS)), 0, int(TRANSFER_BINS) - 1);
  int low = int(texelFetch(transferPieceBins, 2 * bin).x);
  int high = int(texelFetch(transferPieceBins, 2 * bin + 1).x);
  // Most bins lie within one piece. The bound is more than any bin needs; a constant one would have the loop unrolled.
  const int pieces = textureSize(transferPieces) / int(TRANSFER_PIECE_TEXELS);
  for (int round = 0; round < pieces; round++) {
    if (low >= high) break;
    const int middle = (low + high) / 2;
    const bool isBehind = texelFetch(transferPieces, 3 * middle).y <= scalar;
    low = isBehind ? middle + 1 : low;
    high = isBehind ? high : middle;
  }
  return low;
}

Optics opticsInPiece(int piece, float scalar) {
  const vec4 range = texelFetch(transferPieces, 3 * piece);
  const float s = clamp(scalar, range.x, range.y) - range.x;
  return Optics(texelFetch(transferPieces, 3 * piece + 1).xyz + texelFetch(transferPieces, 3 * piece + 2).xyz * s,
                range.z + range.w * s);
}

Optics classify(float scalar) { return opticsInPiece(pieceOf(scalar), scalar); }

#endif
