// Sizes that C++ and GLSL agree on.
#ifndef TETRALUX_SHARED_LIMITS_H
#define TETRALUX_SHARED_LIMITS_H

#include "types.h"

SHARED_BEGIN

// Key of a culled cell; real keys have at most 31 bits.
SHARED_CONST uint KEY_CULLED = 0xffffffffu;

// A projected cell is a fan of four triangles round a centre: one centre and four ring vertices.
SHARED_CONST uint FAN_VERTICES = 5;
SHARED_CONST uint FAN_INDICES = 12;

// Cells projected and drawn at a time. 2^18 cells are 31 MiB of vertices and 12 MiB of indices: large enough that the
// cost of a render pass (loading and storing the attachment) does not show, small enough to matter little beside the
// mesh and to stay below the 128 MiB that a descriptor reaches on every device.
SHARED_CONST uint BATCH_CELLS = 262144;

// Radix sort: 8 bits a pass.
SHARED_CONST uint SORT_DIGIT_BITS = 8;
SHARED_CONST uint SORT_DIGITS = 256;

// Uniform bins over the scalar's range, each naming the transfer function's pieces at its two ends.
SHARED_CONST uint TRANSFER_BINS = 256;
// Texels per piece of the transfer function.
SHARED_CONST uint TRANSFER_PIECE_TEXELS = 3;

SHARED_END

#endif
