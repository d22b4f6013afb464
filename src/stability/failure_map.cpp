#include "stability/failure_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "base/xml_text.h"
#include "stability/color_scale.h"

namespace tetralux::stability {
namespace {

constexpr double kCellWidth = 42.0;
constexpr double kCellHeight = 19.0;
constexpr double kGroupGap = 8.0;  // between columns of different axes
constexpr double kLeft = 176.0;    // of the first column
constexpr double kTop = 204.0;     // of the first row
constexpr double kMargin = 16.0;

std::string hex(const Rgb8& c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

// One digit and an exponent: "3e-5".
std::string shortNumber(double value) {
  if (value == 0.0) return "0";
  int exponent = static_cast<int>(std::floor(std::log10(value)));
  long digit = std::lround(value / std::pow(10.0, exponent));
  if (digit == 10) {
    digit = 1;
    exponent++;
  }
  return exponent == 0 ? fmt::format("{}", digit) : fmt::format("{}e{}", digit, exponent);
}

struct Column {
  std::string method, axis, name;
  double left = 0.0;
};

// Rows and columns in the order in which they first come.
struct Layout {
  std::vector<std::string> rows;
  std::vector<Column> columns;
  std::map<std::pair<std::string, std::string>, const Outcome*> cells;
  double width = 0.0;

  explicit Layout(std::span<const Outcome> outcomes) {
    double left = kLeft;
    for (const Outcome& o : outcomes) {
      if (std::find(rows.begin(), rows.end(), o.region) == rows.end()) rows.push_back(o.region);
      const auto isIt = [&](const Column& c) { return c.method == o.method; };
      if (std::none_of(columns.begin(), columns.end(), isIt)) {
        const size_t space = o.method.find(' ');
        Column column{o.method, o.method.substr(0, space), o.method};
        if (space != std::string::npos) column.name = o.method.substr(space + 1);
        if (!columns.empty() && columns.back().axis != column.axis) left += kGroupGap;
        column.left = left;
        left += kCellWidth;
        columns.push_back(std::move(column));
      }
      cells[{o.region, o.method}] = &o;
    }
    width = left + kMargin;
  }

  double top(size_t row) const { return kTop + static_cast<double>(row) * kCellHeight; }
};

bool isStrict(const std::string& method) {
  const auto& list = methods();
  return std::any_of(list.begin(), list.end(), [&](const Method& m) { return m.isStrict && m.fullName() == method; });
}

std::string cellSvg(const Outcome& o, double left, double top) {
  if (!o.applies)
    return fmt::format(
        "<g><title>{}, {}: does not apply</title><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
        "fill=\"#f2f2f2\"/><text x=\"{}\" y=\"{}\" class=\"v\" fill=\"#999999\">-</text></g>\n",
        escapedXml(o.region), escapedXml(o.method), left, top, kCellWidth - 1.0, kCellHeight - 1.0,
        left + 0.5 * (kCellWidth - 1.0), top + 13.0);
  const Rgb8 color = errorColor(o.nonFinite > 0 ? 1.0 : o.largest);
  const bool isMissed = isStrict(o.method) && !o.keepsLimits();
  std::string text = o.nonFinite > 0 ? "NaN" : shortNumber(o.largest);
  std::string svg = fmt::format(
      "<g><title>{}, {}: largest {:.3g}, RMSE {:.3g}{}{}</title><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
      "fill=\"{}\"/><text x=\"{}\" y=\"{}\" class=\"v{}\" fill=\"{}\">{}</text>",
      escapedXml(o.region), escapedXml(o.method), o.largest, o.rmse, o.worstCase.empty() ? "" : " in ",
      escapedXml(o.worstCase), left, top, kCellWidth - 1.0, kCellHeight - 1.0, hex(color),
      left + 0.5 * (kCellWidth - 1.0), top + 13.0, o.largest > kLargestError ? " b" : "",
      wantsBlackText(color) ? "#000000" : "#ffffff", text);
  if (isMissed)
    svg += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#d81b60\" stroke-width=\"3\"/>",
        left + 0.5, top + 0.5, kCellWidth - 2.0, kCellHeight - 2.0);
  return svg + "</g>\n";
}

std::string headSvg(const Layout& layout) {
  std::string svg;
  for (size_t i = 0; i < layout.columns.size(); i++) {
    const Column& c = layout.columns[i];
    const double x = c.left + 0.5 * kCellWidth;
    const bool isFirst = i == 0 || layout.columns[i - 1].axis != c.axis;
    size_t last = i;
    while (last + 1 < layout.columns.size() && layout.columns[last + 1].axis == c.axis) last++;
    // A column by itself is too narrow for its axis's name above it.
    const bool isAlone = isFirst && last == i;
    svg += fmt::format("<text transform=\"translate({} {}) rotate(-55)\" class=\"h\">{}</text>\n", x, kTop - 8.0,
                       escapedXml(isAlone ? c.method : c.name));
    if (c.axis == c.name || !isFirst) continue;
    const double right = layout.columns[last].left + kCellWidth - 1.0;
    if (!isAlone)
      svg += fmt::format("<text x=\"{}\" y=\"70\" class=\"a\">{}</text>\n", c.left + 36.0, escapedXml(c.axis));
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"2\" fill=\"#555555\"/>\n", c.left, kTop - 5.0,
                       right - c.left);
  }
  return svg;
}

std::string legendSvg(const Layout& layout) {
  const double top = layout.top(layout.rows.size()) + 18.0;
  constexpr double kWidth = 420.0;
  constexpr int kSteps = 84;
  const double decades = std::log10(kScaleHigh / kScaleLow);
  const auto place = [&](double error) { return kLeft + kWidth * std::log10(error / kScaleLow) / decades; };
  std::string svg;
  for (int i = 0; i < kSteps; i++) {
    const double error = kScaleLow * std::pow(10.0, decades * (i + 0.5) / kSteps);
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"14\" fill=\"{}\"/>\n",
                       kLeft + kWidth * i / kSteps, top, kWidth / kSteps + 0.3, hex(errorColor(error)));
  }
  for (int exponent = -7; exponent <= 0; exponent++) {
    const double x = place(std::pow(10.0, exponent));
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"1\" height=\"5\" fill=\"#000000\"/>", x - 0.5, top + 14.0);
    svg += fmt::format("<text x=\"{}\" y=\"{}\" class=\"v\">{}</text>\n", x, top + 30.0,
                       exponent == 0 ? "1" : fmt::format("1e{}", exponent));
  }
  svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"2\" height=\"22\" fill=\"#d81b60\"/>", place(kLargestError) - 1.0,
                     top - 4.0);
  const double right = kLeft + kWidth + 24.0;
  svg += fmt::format(
      "<text x=\"{}\" y=\"{}\" class=\"l\">largest error of a channel; 1e-7 and less alike. "
      "Line and bold: over 1/255.</text>\n",
      right, top + 9.0);
  svg += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"22\" height=\"11\" fill=\"none\" stroke=\"#d81b60\" "
      "stroke-width=\"3\"/><text x=\"{}\" y=\"{}\" class=\"l\">misses a limit that it must keep "
      "(RMSE 5e-5, largest 1/255)</text>\n",
      right + 1.0, top + 19.0, right + 32.0, top + 29.0);
  return svg;
}

}  // namespace

std::string failureMapSvg(std::span<const Outcome> outcomes, const std::string& device) {
  const Layout layout(outcomes);
  const double height = layout.top(layout.rows.size()) + 62.0;
  const double width = std::max(layout.width, 1040.0);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"DejaVu Sans, Verdana, sans-serif\">\n"
      "<style>.v{{font-size:10.5px;text-anchor:middle}}.b{{font-weight:bold}}.h{{font-size:12px}}"
      ".a{{font-size:13px;font-weight:bold}}.r{{font-size:12px;text-anchor:end}}.l{{font-size:12px}}"
      ".t{{font-size:17px;font-weight:bold}}</style>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n"
      "<text x=\"{2}\" y=\"28\" class=\"t\">Largest error where methods fail: {3}</text>\n"
      "<text x=\"{2}\" y=\"48\" class=\"l\">the default, and pt with one part replaced at a time; against the "
      "double-precision answer</text>\n",
      width, height, kMargin, escapedXml(device));
  svg += headSvg(layout);
  for (size_t row = 0; row < layout.rows.size(); row++) {
    svg += fmt::format("<text x=\"{}\" y=\"{}\" class=\"r\">{}</text>\n", kLeft - 8.0, layout.top(row) + 13.5,
                       escapedXml(layout.rows[row]));
    for (const Column& column : layout.columns) {
      const auto cell = layout.cells.find({layout.rows[row], column.method});
      if (cell != layout.cells.end()) svg += cellSvg(*cell->second, column.left, layout.top(row));
    }
  }
  return svg + legendSvg(layout) + "</svg>\n";
}

std::string failureMapHtml(std::span<const Outcome> outcomes, const std::string& device) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>tetralux: stability on {0}</title>\n"
      "<style>body{{font-family:DejaVu Sans,Verdana,sans-serif;margin:1.5em;max-width:1400px}}"
      "svg{{width:100%;height:auto}}td,th{{padding:2px 10px;text-align:left}}td.n{{text-align:right}}"
      "tr:nth-child(even){{background:#f4f4f4}}</style></head><body>\n"
      "<p>Every region draws hard cases with every method and compares each picture with the double-precision answer. "
      "Rest the pointer on a cell for its figures.</p>\n",
      escapedXml(device));
  html += failureMapSvg(outcomes, device);
  html += "<h2>Regions</h2>\n<table><tr><th>region</th><th>what is in it</th></tr>\n";
  const Layout layout(outcomes);
  for (const Region& region : regions()) {
    if (std::find(layout.rows.begin(), layout.rows.end(), region.name) != layout.rows.end())
      html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escapedXml(region.name), escapedXml(region.what));
  }
  html +=
      "</table>\n<h2>Figures</h2>\n<table><tr><th>region</th><th>method</th><th>RMSE</th><th>largest</th>"
      "<th>not finite</th><th>worst case</th></tr>\n";
  for (const Outcome& o : outcomes) {
    if (!o.applies) continue;
    html += fmt::format(
        "<tr><td>{}</td><td>{}</td><td class=\"n\">{:.3g}</td><td class=\"n\">{:.3g}</td>"
        "<td class=\"n\">{}</td><td>{}</td></tr>\n",
        escapedXml(o.region), escapedXml(o.method), o.rmse, o.largest, o.nonFinite, escapedXml(o.worstCase));
  }
  return html + "</table>\n</body></html>\n";
}

}  // namespace tetralux::stability
