// Sort keys by power distance (order/power_key.comp, order/power_ties.comp).
#ifndef TETRALUX_SHARED_POWER_KEYS_H
#define TETRALUX_SHARED_POWER_KEYS_H

#include "types.h"

SHARED_BEGIN

// A key is a number of 29 bits, farthest first, above a level of two: how many neighbours with the same number lie behind each
// other behind the cell.
SHARED_CONST uint POWER_KEY_BITS = 31;
SHARED_CONST uint POWER_LEVEL_BITS = 2;
SHARED_CONST uint POWER_LEVELS = 4;

// Powers of points in the mesh's box are scaled to [-POWER_INSIDE, POWER_INSIDE]. A circumsphere's may lie outside; beyond
// this, keys are spaced logarithmically.
SHARED_CONST float POWER_INSIDE = 0.875f;

SHARED_END

#endif
