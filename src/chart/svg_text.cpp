#include "chart/svg_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/xml_text.h"

namespace tetralux::chart {
namespace {

// Rules by class, not variables: not every program that shows SVG knows those. Text and marks that stand for a series
// take its colour; "ground" is what lies behind.
constexpr std::string_view kStyle =
    "text{font-family:system-ui,'DejaVu Sans',sans-serif;fill:#24292f;font-size:11px}"
    ".title{font-size:15px;font-weight:600}.axis{font-size:12px}.middle{text-anchor:middle}.end{text-anchor:end}"
    ".tick{fill:#57606a}.strong{font-weight:700}.ground{fill:#fff;stroke:none}"
    ".grid{stroke:#d8dee4;stroke-width:1;fill:none}.fine{stroke:#eef1f4;stroke-width:1;fill:none}"
    ".frame{stroke:#8c959f;stroke-width:1;fill:none}.leader{stroke:#8c959f;stroke-width:.7;fill:none}"
    ".front{stroke:#24292f;stroke-width:1.5;stroke-dasharray:5 3;fill:none}"
    ".label{stroke:#fff;stroke-width:3;stroke-linejoin:round;paint-order:stroke}"
    ".mark{stroke:#fff;stroke-width:.8}.line{fill:none;stroke-width:2}"
    ".c0{fill:#0969da}.c1{fill:#bc4c00}.c2{fill:#1a7f37}.c3{fill:#8250df}.c4{fill:#bf3989}.c5{fill:#9a6700}"
    ".c6{fill:#1b7c83}.c7{fill:#57606a}"
    ".line.c0{stroke:#0969da}.line.c1{stroke:#bc4c00}.line.c2{stroke:#1a7f37}.line.c3{stroke:#8250df}"
    ".line.c4{stroke:#bf3989}.line.c5{stroke:#9a6700}.line.c6{stroke:#1b7c83}.line.c7{stroke:#57606a}.line{fill:none}"
    "@media(prefers-color-scheme:dark){text{fill:#e6edf3}.tick{fill:#9da7b3}.ground{fill:#0d1117}"
    ".grid{stroke:#30363d}.fine{stroke:#1c2128}.frame,.leader{stroke:#6e7681}.front{stroke:#e6edf3}"
    ".mark,.label{stroke:#0d1117}"
    ".c0{fill:#58a6ff}.c1{fill:#f0883e}.c2{fill:#3fb950}.c3{fill:#a371f7}.c4{fill:#f778ba}.c5{fill:#d29922}"
    ".c6{fill:#39c5cf}.c7{fill:#9da7b3}"
    ".line.c0{stroke:#58a6ff}.line.c1{stroke:#f0883e}.line.c2{stroke:#3fb950}.line.c3{stroke:#a371f7}"
    ".line.c4{stroke:#f778ba}.line.c5{stroke:#d29922}.line.c6{stroke:#39c5cf}.line.c7{stroke:#9da7b3}"
    ".line{fill:none}}";

std::string superscript(int exponent) {
  static const char* const kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char digit : fmt::format("{}", std::abs(exponent))) text += kDigits[digit - '0'];
  return text;
}

}  // namespace

std::string numberText(double value) {
  if (value == 0.0 || !std::isfinite(value)) return fmt::format("{:g}", value);
  const double size = std::abs(value);
  if (size >= 1e-3 * (1 - 1e-9) && size < 1e4) return fmt::format("{:.4g}", value);
  for (const auto& [unit, suffix] : {std::pair(1e9, "G"), std::pair(1e6, "M"), std::pair(1e3, "k")}) {
    if (size >= std::max(unit, 1e4) && size < 1e12) return fmt::format("{:.4g}\u202f{}", value / unit, suffix);
  }
  const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-9));
  const double mantissa = value / std::pow(10.0, exponent);
  const std::string power = "10" + superscript(exponent);
  return std::abs(mantissa - 1.0) < 1e-6 ? power : fmt::format("{:.3g}·{}", mantissa, power);
}

std::string svgHead(double width, double height, std::string_view title) {
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:g} {1:g}" width="{0:g}" height="{1:g}" role="img">)"
      R"(<title>{2}</title><style>{3}</style><rect class="ground" width="{0:g}" height="{1:g}"/>)",
      width, height, escapedXml(title), kStyle);
}

std::string dataUri(std::string_view type, std::span<const std::byte> bytes) {
  static constexpr char kAlphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string uri = fmt::format("data:{};base64,", type);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t count = std::min<size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (size_t k = 0; k < 3; k++) group = group << 8 | (k < count ? std::to_integer<unsigned>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; k++) uri += k <= count ? kAlphabet[group >> (18 - 6 * k) & 63u] : '=';
  }
  return uri;
}

}  // namespace tetralux::chart
