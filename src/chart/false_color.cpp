#include "chart/false_color.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "chart/svg_text.h"
#include "image/color.h"
#include "image/same_size.h"

namespace tetralux::chart {
namespace {

// sRGB-encoded hues at even shares, dark to light. Their lightness is corrected below.
constexpr std::array<glm::dvec3, 8> kHues = {{{0.00, 0.00, 0.00},
                                              {0.16, 0.10, 0.48},
                                              {0.42, 0.10, 0.62},
                                              {0.72, 0.16, 0.48},
                                              {0.92, 0.34, 0.28},
                                              {0.98, 0.60, 0.20},
                                              {0.98, 0.84, 0.40},
                                              {1.00, 1.00, 1.00}}};

double lightness(const glm::dvec3& linear) { return labFromRelativeXyz(relativeXyzFromRgb() * linear).x; }

glm::dvec3 hueOfShare(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (kHues.size() - 1);
  const size_t low = std::min(static_cast<size_t>(place), kHues.size() - 2);
  const glm::dvec3 encoded = kHues[low] + (place - static_cast<double>(low)) * (kHues[low + 1] - kHues[low]);
  return {linearFromSrgb(encoded.x), linearFromSrgb(encoded.y), linearFromSrgb(encoded.z)};
}

// The place on the ramp of hues whose lightness is 100 times `share`; lightness rises along the ramp.
glm::dvec3 evenColor(double share) {
  double low = 0.0;
  double high = 1.0;
  for (int step = 0; step < 40; step++) {
    const double middle = 0.5 * (low + high);
    (lightness(hueOfShare(middle)) < 100.0 * share ? low : high) = middle;
  }
  return hueOfShare(0.5 * (low + high));
}

// Few enough for a palette, and for a picture that compresses; six to a decade.
constexpr size_t kSteps = 6 * static_cast<size_t>(-kLowestDecade) + 1;

}  // namespace

glm::dvec3 colorOfShare(double share) {
  static const std::array<glm::dvec3, kSteps> table = [] {
    std::array<glm::dvec3, kSteps> colors;
    for (size_t i = 0; i < kSteps; i++) colors[i] = evenColor(static_cast<double>(i) / (kSteps - 1));
    return colors;
  }();
  return table[static_cast<size_t>(std::lround(std::clamp(share, 0.0, 1.0) * (kSteps - 1)))];
}

glm::dvec3 colorOfDifference(double difference) {
  if (std::isnan(difference)) return colorOfShare(1.0);
  if (!(difference > 0.0)) return colorOfShare(0.0);
  return colorOfShare(1.0 - std::log10(difference) / kLowestDecade);
}

Image differencePicture(const Image& reference, const Image& test) {
  requireSameSize(reference, test);
  Image picture(reference.width, reference.height);
  for (size_t i = 0; i < picture.pixels.size(); i++) {
    double largest = 0.0;
    for (int c = 0; c < 4; c++) {
      const double difference = std::abs(double{reference.pixels[i][c]} - double{test.pixels[i][c]});
      largest = std::max(largest, std::isfinite(difference) ? difference : 1.0);
    }
    picture.pixels[i] = glm::vec4(glm::dvec4(colorOfDifference(largest), 1.0));
  }
  return picture;
}

std::string differenceLegendSvg() {
  constexpr double kWidth = 430;
  constexpr double kLeft = 30;
  std::string svg = svgHead(kWidth + 2 * kLeft, 44, "Scale of the difference images");
  // One bar per colour, which stands for the differences that are rounded to it.
  constexpr double kStep = kWidth / (kSteps - 1);
  for (size_t i = 0; i < kSteps; i++) {
    const glm::dvec3 color = colorOfShare(static_cast<double>(i) / (kSteps - 1));
    const auto level = [](double linear) { return std::lround(255.0 * srgbFromLinear(linear)); };
    svg += fmt::format(R"(<rect x="{:.1f}" y="4" width="{:.1f}" height="16" fill="#{:02x}{:02x}{:02x}"/>)",
                       kLeft + kStep * (static_cast<double>(i) - 0.5), kStep + 0.2, level(color.x), level(color.y),
                       level(color.z));
  }
  svg += fmt::format(R"(<rect class="frame" x="{:.1f}" y="4" width="{:.1f}" height="16"/>)", kLeft - 0.5 * kStep,
                     kWidth + kStep);
  for (int decade = kLowestDecade; decade <= 0; decade++) {
    const double x = kLeft + kWidth * (1.0 - static_cast<double>(decade) / kLowestDecade);
    svg +=
        fmt::format(R"(<text class="tick middle" x="{:.1f}" y="36">{}</text>)", x, numberText(std::pow(10.0, decade)));
  }
  return svg + "</svg>\n";
}

}  // namespace tetralux::chart
