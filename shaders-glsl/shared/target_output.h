// What a fragment shader hands to the blending.
#ifndef TETRALUX_SHARED_TARGET_OUTPUT_H
#define TETRALUX_SHARED_TARGET_OUTPUT_H

#include "types.h"

SHARED_BEGIN

SHARED_CONST uint OUTPUT_COLOR = 0;
// Rounded to 8 bits, up or down at random (Kraus, Qiao and Ebert 2004, section 4.2).
SHARED_CONST uint OUTPUT_DITHERED = 1;
// Not a colour but what roundings of a target's value after every layer would add up to, in units of one rounding. A layer of
// opacity alpha multiplies all errors behind it by 1 - alpha: with T_i the transmittance in front of layer i,
//     OUTPUT_ROUNDINGS     sum T_i^2   variance of independent roundings; min(N, 1/(2 alpha)) for N equal thin layers
//     OUTPUT_TRUNCATIONS   sum T_i     sum of roundings that all have one sense; min(N, 1/alpha)
SHARED_CONST uint OUTPUT_ROUNDINGS = 2;
SHARED_CONST uint OUTPUT_TRUNCATIONS = 3;
// The same faint grey from every fragment, not integrated: what drawing costs at least (render/floor_times.h).
SHARED_CONST uint OUTPUT_CONSTANT = 4;

SHARED_END

#endif
