#include "stability/color_scale.h"

#include <algorithm>
#include <cmath>

namespace tetralux::stability {
namespace {

// Every ninth of viridis, from its light end.
constexpr std::array<Rgb8, 10> kViridis = {{{253, 231, 37},
                                            {181, 222, 43},
                                            {110, 206, 88},
                                            {53, 183, 121},
                                            {31, 158, 137},
                                            {38, 130, 142},
                                            {49, 104, 142},
                                            {62, 73, 137},
                                            {72, 40, 120},
                                            {68, 1, 84}}};

}  // namespace

Rgb8 errorColor(double error) {
  const double decades = std::log10(kScaleHigh / kScaleLow);
  const double share = std::clamp(std::log10(std::max(error, kScaleLow) / kScaleLow) / decades, 0.0, 1.0);
  const double place = share * static_cast<double>(kViridis.size() - 1);
  const size_t index = std::min(static_cast<size_t>(place), kViridis.size() - 2);
  const double t = place - static_cast<double>(index);
  const auto mix = [&](std::uint8_t Rgb8::*channel) {
    const double a = kViridis[index].*channel;
    const double b = kViridis[index + 1].*channel;
    return static_cast<std::uint8_t>(std::lround(a + t * (b - a)));
  };
  return {mix(&Rgb8::r), mix(&Rgb8::g), mix(&Rgb8::b)};
}

bool wantsBlackText(const Rgb8& color) {
  // Relative luminance (ITU-R BT.709), of values that are not linear: good enough for a choice of two.
  return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b > 115.0;
}

}  // namespace tetralux::stability
