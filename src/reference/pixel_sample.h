// A random sample of an image's pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "reference/ray_caster.h"

namespace tetralux::reference {

// Pixels at random, as evenly spread as their number allows: wanted pixels are numbered tile by tile and cut into
// `count` strata of equal length, and one is taken from each. Every wanted pixel is as likely as any other, and one may
// come twice at the end of a stratum. All of them, once each, when there are no more than `count`.
//   wanted   one flag per pixel, row by row from the top
//   seed     the same seed gives the same pixels on every machine
std::vector<PixelPosition> stratifiedPixels(ImageSize size, const std::vector<std::uint8_t>& wanted,
                                            std::uint32_t count, std::uint32_t seed);

}  // namespace tetralux::reference
