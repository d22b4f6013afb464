// Differences that eyes can read.
#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "image/image.h"

namespace tetralux::chart {

// Differences from 10^kLowestDecade to 1 are spread over the colours logarithmically; below it is black, above it
// white.
constexpr int kLowestDecade = -7;

// A colour map whose lightness (CIE L*) rises evenly, so that larger looks larger without the legend: black, blue,
// violet, red, orange, yellow, white. Result: linear RGB.
//   share   clamped to [0, 1]
glm::dvec3 colorOfShare(double share);

// The colour of a difference on the scale above; not-a-number is the colour of 1.
glm::dvec3 colorOfDifference(double difference);

// Per pixel, the largest absolute difference of the four channels as a colour, alpha 1. A value that is not finite
// counts as 1. Throws Error(Input) when the sizes differ.
Image differencePicture(const Image& reference, const Image& test);

// The scale as SVG, with a tick per decade. Inline or a file.
std::string differenceLegendSvg();

}  // namespace tetralux::chart
