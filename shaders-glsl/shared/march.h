// The march (march/): rays walking through the mesh's adjacency.
#ifndef TETRALUX_SHARED_MARCH_H
#define TETRALUX_SHARED_MARCH_H

#include "types.h"

SHARED_BEGIN

// Side of the square of pixels that a workgroup works on.
SHARED_CONST uint MARCH_TILE = 8;

// Rounds of a ray in one dispatch; what is left is done by another. Mesa's software device ends every loop after 65535 rounds,
// silently, and other devices stop work that takes seconds.
SHARED_CONST uint MARCH_ROUNDS = 16384;
// Cells instead, where a method looks for the pieces of the transfer function at a cell's two ends: those searches are loops, too, of
// up to twenty rounds, and may count against the same limit.
SHARED_CONST uint MARCH_CELLS = 1536;
SHARED_CONST uint MARCH_LAST_ROUND = 65000;  // for the parts of the last cell, which is not left half done

// Triangles drawn per boundary face: a rectangle round it.
SHARED_CONST uint MARCH_FACE_VERTICES = 6;

SHARED_END

#endif
