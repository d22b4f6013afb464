// Errors as colours.
#pragma once

#include <array>
#include <cstdint>

namespace tetralux::stability {

struct Rgb8 {
  std::uint8_t r, g, b;
};

// Ends of the scale: at or below the first and at or above the second colours stay the same.
inline constexpr double kScaleLow = 1e-7;
inline constexpr double kScaleHigh = 1.0;

// Light for small errors, dark for large ones, the same step of lightness for every decade: viridis (van der Walt and
// Smith 2015), which keeps its order for colour-blind eyes and in grey.
Rgb8 errorColor(double error);

// Whether black text shows better on a colour than white.
bool wantsBlackText(const Rgb8& color);

}  // namespace tetralux::stability
