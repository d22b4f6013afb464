// What lies across the faces of cells, by its address: a list in pieces (gpu/pieced_buffer.h), four entries to a cell. What an entry is:
// ray_walk.glsl.
#include "include/pieces.glsl"

layout(buffer_reference, scalar, buffer_reference_align = 8) buffer AcrossPieceAt { uvec2 data[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer AcrossAt {
  uint bits;
  uint unused;
  AcrossPieceAt pieces[kMostPieces];
};

// Of a cell: the piece that it is in, and where its entries begin there.
AcrossPieceAt acrossPiece(AcrossAt at, uint cell) { return at.pieces[cell >> at.bits]; }
uint acrossPlace(AcrossAt at, uint cell) { return 4u * (cell & ((1u << at.bits) - 1u)); }
