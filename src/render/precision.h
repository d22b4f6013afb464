// Whether rays need double precision to find where they cross faces.
#pragma once

#include <optional>

namespace tetralux::render {

// In single precision a ray crosses a face about so far from where it should, in mesh units (space within [-1, 1]):
// positions, their turning into the view and the crossing are each rounded to 2^-24.
inline constexpr double kCrossingRounding = 3e-7;

// What is crossed too late in one cell is crossed too early in the next, so a picture errs by less than the optical
// depth of that length: mostly by much less, but all of it where the medium is opaque within so thin a layer.
//   largestExtinction   1/mesh unit
//   tolerance           largest error per pixel and channel; nothing: that of the default limits, 1/255
bool isTooDenseForSingle(double largestExtinction, std::optional<double> tolerance);

// A picture is also shifted by that length, which shows where pixels are not much larger.
//   smallestPixel   side of a pixel where the mesh is nearest, mesh units
bool isTooFineForSingle(double smallestPixel);

}  // namespace tetralux::render
