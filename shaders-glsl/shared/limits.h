// Sizes that C++ and GLSL agree on.
#ifndef TETRALUX_SHARED_LIMITS_H
#define TETRALUX_SHARED_LIMITS_H

#include "types.h"

SHARED_BEGIN

// Sort keys: smaller is drawn first. Real keys have at most 31 bits. A transparent cell is not drawn, but keeps its key
// beside this bit, because the order of cells on its two sides hangs on it.
SHARED_CONST uint KEY_TRANSPARENT = 0x80000000u;
// Key of a cell that no pixel's ray meets.
SHARED_CONST uint KEY_OUTSIDE = 0xffffffffu;

// A projected cell is a fan of four triangles round a centre: one centre and four ring vertices.
SHARED_CONST uint FAN_VERTICES = 5;
SHARED_CONST uint FAN_INDICES = 12;
// As an outline, it is the ring alone: two triangles.
SHARED_CONST uint OUTLINE_INDICES = 6;

// Cells projected and drawn at a time. 2^18 cells are 31 MiB of vertices and 12 MiB of indices: large enough that the
// cost of a render pass (loading and storing the attachment) does not show, small enough to matter little beside the
// mesh and to stay below the 128 MiB that a descriptor reaches on every device.
SHARED_CONST uint BATCH_CELLS = 262144;

// Radix sort: 8 bits a pass.
SHARED_CONST uint SORT_DIGIT_BITS = 8;
SHARED_CONST uint SORT_DIGITS = 256;

// Uniform bins over the scalar's range, each naming the transfer function's pieces at its two ends.
SHARED_CONST uint TRANSFER_BINS = 256;
// Largest extinction (or emission per length) of 1, 2, 4, ... 256 bins from each bin on.
SHARED_CONST uint EXTINCTION_LEVELS = 9;
// Texels per piece of the transfer function.
SHARED_CONST uint TRANSFER_PIECE_TEXELS = 3;

SHARED_END

#endif
