// When a cell is too close to the eye's plane to be projected.
#ifndef TETRALUX_SHARED_NEAR_CELLS_H
#define TETRALUX_SHARED_NEAR_CELLS_H

#include "types.h"

SHARED_BEGIN

// A cell is near when it reaches the eye's plane, or comes so close to it that its projection would be many times larger
// than what can be seen of it: then screen coordinates lose their digits, and the cell is drawn by clipping rays against
// its faces instead. Below this ratio of its smallest to its largest depth it is near; a projected coordinate keeps
// 2^-17 of the cell's size down to it.
SHARED_CONST float NEAR_DEPTH_RATIO = 1.0f / 64.0f;

SHARED_END

#endif
