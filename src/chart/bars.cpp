#include "chart/bars.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/xml_text.h"
#include "chart/axis.h"
#include "chart/label_placement.h"
#include "chart/svg_text.h"

namespace tetralux::chart {

std::string barsSvg(const std::string& title, const std::string& baseText, const std::string& totalText,
                    const std::vector<Bar>& bars) {
  constexpr double kWidth = 960, kRow = 30, kTop = 66, kRoom = 80;  // right of the bars, for their numbers
  double left = 84.0;
  std::vector<double> totals;
  for (const Bar& bar : bars) {
    left = std::max(left, 30.0 + textWidth(bar.name, 11.0));
    totals.push_back(bar.total);
  }
  const Axis axis = Axis::linearFromZero(totals);
  const double bottom = kTop + kRow * static_cast<double>(bars.size()) + 6.0;
  const auto x = [&](double value) { return left + (kWidth - kRoom - left) * axis.share(value); };
  std::string svg = svgHead(kWidth, bottom + 34.0, title);
  svg += fmt::format(R"(<text class="title" x="24" y="28">{}</text>)", escapedXml(title));
  svg +=
      fmt::format(R"(<rect class="c0" x="{0:.1f}" y="40" width="12" height="12"/><text x="{1:.1f}" y="50">{2}</text>)"
                  R"(<rect class="c1" x="{3:.1f}" y="40" width="12" height="12"/><text x="{4:.1f}" y="50">{5}</text>)",
                  24.0, 42.0, escapedXml(baseText), 80.0 + textWidth(baseText, 11.0), 98.0 + textWidth(baseText, 11.0),
                  escapedXml(totalText));
  for (const Tick& tick : axis.ticks())
    svg += fmt::format(
        R"(<path class="grid" d="M{0:.1f} {1}V{2:.1f}"/><text class="tick middle" x="{0:.1f}" y="{3:.1f}">{4}</text>)",
        x(tick.value), kTop - 4, bottom, bottom + 17.0, tick.text);
  for (size_t i = 0; i < bars.size(); i++) {
    const Bar& bar = bars[i];
    const double y = kTop + kRow * static_cast<double>(i);
    svg += fmt::format(
        R"(<text class="end" x="{:.1f}" y="{:.1f}">{}</text><rect class="c0" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="20"/>)",
        left - 8.0, y + 18.0, escapedXml(bar.name), left, y + 4.0, x(bar.base) - left);
    svg += fmt::format(
        R"(<rect class="c1" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="20"/><text class="strong" x="{:.1f}" y="{:.1f}">+{:.1f} %</text>)",
        x(bar.base), y + 4.0, x(bar.total) - x(bar.base), x(bar.total) + 6.0, y + 18.0,
        bar.base > 0.0 ? 100.0 * (bar.total / bar.base - 1.0) : 0.0);
  }
  return svg + "</svg>\n";
}

}  // namespace tetralux::chart
