// Smaller pictures for a report.
#pragma once

#include "image/image.h"

namespace tetralux::chart {

// What becomes of the pixels that share a place in the smaller picture.
enum class Shrink {
  Mean,      // what one sees from farther away
  Lightest,  // the one with the largest sum of channels: a difference of one pixel is still seen
};

// The picture with its longer side at most `side` pixels (>= 1), made of whole blocks of n x n pixels; itself where it
// is no larger.
Image thumbnail(const Image& image, std::uint32_t side, Shrink shrink);

}  // namespace tetralux::chart
