// The transfer function: its linear pieces, and what it says at one scalar.
//
// Before including: TRANSFER_PIECES and TRANSFER_PIECE_BINS are the binding numbers.
#ifndef TETRALUX_INTEGRATION_TRANSFER_PIECES
#define TETRALUX_INTEGRATION_TRANSFER_PIECES

// Piece i is texels 3i to 3i+2:
//   x scalar at its low end, y at its high end, z extinction at the low end (1/mesh unit), w its slope
//   xyz luminance at the low end: L, or E (1/mesh unit) with emission per length
//   xyz its slope
// End pieces are constant and reach to -1e30 and 1e30.
layout(binding = TRANSFER_PIECES) uniform samplerBuffer transferPieces;
// Bin b covers scalars from -0.5 + b/TRANSFER_BINS to the next; texel 2b: the piece at its low end, 2b+1: at its high end.
layout(binding = TRANSFER_PIECE_BINS) uniform usamplerBuffer transferPieceBins;

// Luminance and extinction (1/mesh unit).
struct Optics {
  vec3 luminance;
  float extinction;
};

// Index of the piece that holds a scalar; on a control point, the piece after it.
int pieceOf(float scalar) {
  const int bin = clamp(int((scalar + 0.5) * float(TRANSFER_BINS)), 0, int(TRANSFER_BINS) - 1);
  int piece = int(texelFetch(transferPieceBins, 2 * bin).x);
  const int pieces = textureSize(transferPieces) / int(TRANSFER_PIECE_TEXELS);
  for (int round = 0; round < pieces; round++) {
    if (texelFetch(transferPieces, 3 * piece).y > scalar) break;
    piece++;
  }
  return piece;
}

Optics opticsInPiece(int piece, float scalar) {
  const vec4 range = texelFetch(transferPieces, 3 * piece);
  const float s = clamp(scalar, range.x, range.y) - range.x;
  return Optics(texelFetch(transferPieces, 3 * piece + 1).xyz + texelFetch(transferPieces, 3 * piece + 2).xyz * s,
                range.z + range.w * s);
}

Optics classify(float scalar) { return opticsInPiece(pieceOf(scalar), scalar); }

#endif
