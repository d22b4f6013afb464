#include "render/precision.h"

namespace tetralux::render {

bool isTooDenseForSingle(double largestExtinction, std::optional<double> tolerance) {
  constexpr double kShare = 1.0 / 8.0;  // of the tolerance, that roundings may cost
  return largestExtinction * kCrossingRounding > kShare * tolerance.value_or(1.0 / 255.0);
}

bool isTooFineForSingle(double smallestPixel) {
  constexpr double kShiftPixels = 1.0 / 50.0;
  return kCrossingRounding > kShiftPixels * smallestPixel;
}

}  // namespace tetralux::render
