// What all charts and the report write alike: numbers, the head of an SVG.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace tetralux::chart {

// A number for a tick: 0.5, 200, 10 k, 5 M, 2 G; beyond that, and below 1e-3, powers of ten.
std::string numberText(double value);

// Opening tag, title for readers of screens, style and ground of a chart. Colours follow the reader's preference of
// light or dark; series are classes c0 .. c7 (kColorCount). The closing tag is the caller's.
//   width, height   pixels
std::string svgHead(double width, double height, std::string_view title);
constexpr int kColorCount = 8;

// "data:TYPE;base64,..." of bytes (RFC 2397, RFC 4648).
std::string dataUri(std::string_view type, std::span<const std::byte> bytes);

}  // namespace tetralux::chart
