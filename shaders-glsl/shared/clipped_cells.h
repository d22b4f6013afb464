// Cells whose projection is not to be trusted: they are drawn by clipping rays against their faces.
#ifndef TETRALUX_SHARED_CLIPPED_CELLS_H
#define TETRALUX_SHARED_CLIPPED_CELLS_H

#include "types.h"

SHARED_BEGIN

// A cell is near when it reaches the eye's plane, or comes so close to it that its projection would be many times larger
// than what can be seen of it: then screen coordinates lose their digits. Below this ratio of its smallest to its largest
// depth it is near; a projected coordinate keeps 2^-17 of the cell's size down to it.
SHARED_CONST float NEAR_DEPTH_RATIO = 1.0f / 64.0f;

// Rasterisers snap vertices to 1/256 pixel, so a pixel's centre up to 1/362 pixel beside an edge may be given to the wrong side
// of it. There the thickness is wrong by its slope times that distance, and the slope is the cell's largest thickness over
// the height h, in pixels, of one of its projected faces: the opacity is wrong by up to min(1, depth) / (362 h), depth being
// the cell's optical depth. A cell with a face that is lower than this, times min(1, depth), is clipped instead; what is left is
// below 1/362 per cell, and rare.
SHARED_CONST float EDGE_ON_HEIGHT = 1.0f;

SHARED_END

#endif
