#include "chart/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/xml_text.h"
#include "chart/label_placement.h"
#include "chart/svg_text.h"

namespace tetralux::chart {
namespace {

constexpr double kWidth = 960, kHeight = 560;
constexpr double kLeft = 84, kTop = 52, kBottom = 56;
constexpr double kRadius = 5.0;
constexpr double kFont = 11.0;
constexpr double kZeroBand = 26.0;  // below a logarithmic axis

std::string classOf(const Style& style) { return fmt::format("c{}", style.color % kColorCount); }

std::string text(double x, double y, const std::string& classes, const std::string& content) {
  return fmt::format(R"(<text class="{}" x="{:.1f}" y="{:.1f}">{}</text>)", classes, x, y, escapedXml(content));
}

std::string segment(const char* classes, double x0, double y0, double x1, double y1) {
  return fmt::format(R"(<path class="{}" d="M{:.1f} {:.1f}L{:.1f} {:.1f}"/>)", classes, x0, y0, x1, y1);
}

// Outline of a mark as a path.
std::string shapePath(Shape shape, double x, double y, double r) {
  const auto polygon = [&](std::initializer_list<std::pair<double, double>> corners) {
    std::string path;
    for (const auto& [dx, dy] : corners)
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x + r * dx, y + r * dy);
    return path + "Z";
  };
  switch (shape) {
    case Shape::Circle:
      return fmt::format("M{:.1f} {:.1f}a{r:g} {r:g} 0 1 0 {d:g} 0a{r:g} {r:g} 0 1 0 -{d:g} 0Z", x - r, y,
                         fmt::arg("r", r), fmt::arg("d", 2 * r));
    case Shape::Square:
      return polygon({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
    case Shape::Triangle:
      return polygon({{0, -1.2}, {1.1, 0.9}, {-1.1, 0.9}});
    case Shape::Diamond:
      return polygon({{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}});
    case Shape::Down:
      return polygon({{0, 1.2}, {1.1, -0.9}, {-1.1, -0.9}});
    case Shape::Cross:
      return polygon({{-1.1, -0.6},
                      {-0.6, -1.1},
                      {0, -0.5},
                      {0.6, -1.1},
                      {1.1, -0.6},
                      {0.5, 0},
                      {1.1, 0.6},
                      {0.6, 1.1},
                      {0, 0.5},
                      {-0.6, 1.1},
                      {-1.1, 0.6},
                      {-0.5, 0}});
  }
  return "";
}

std::string mark(const Style& style, double x, double y, double r, const std::string& tooltip = "") {
  return fmt::format(R"(<path class="mark {}" d="{}">{}</path>)", classOf(style), shapePath(style.shape, x, y, r),
                     tooltip.empty() ? "" : "<title>" + escapedXml(tooltip) + "</title>");
}

class PlotDrawing {
 public:
  explicit PlotDrawing(const Plot& plot) : plot_(plot) {
    double names = 0.0;
    if (!plot.right)
      for (const Line& line : plot.lines) names = std::max(names, textWidth(line.name, kFont) + 20.0);
    right_ = kWidth - (plot.right ? 70.0 : 24.0) - names;
    const bool hasZero = plot.y.axis.isLogarithmic() &&
                         std::any_of(plot.marks.begin(), plot.marks.end(), [](const Mark& m) { return m.y <= 0.0; });
    zeroBand_ = hasZero ? kZeroBand : 0.0;
    legendRows_ = layOutLegend();
    top_ = kTop + 18.0 * static_cast<double>(legendRows_);
    bottom_ = kHeight - kBottom - zeroBand_;
  }

  std::string draw() {
    svg_ = svgHead(kWidth, kHeight, plot_.title);
    svg_ += text(kLeft, 28, "title", plot_.title);
    drawLegend();
    drawXAxis();
    drawYAxis();
    drawFront();
    for (const Line& line : plot_.lines) drawLine(line);
    drawLineNames();
    drawMarks();
    return svg_ + "</svg>\n";
  }

 private:
  double x(double value) const { return kLeft + (right_ - kLeft) * plot_.x.axis.share(value); }
  double y(double value) const {
    if (plot_.y.axis.isLogarithmic() && !(value > 0.0)) return bottom_ + zeroBand_ - 8.0;
    return bottom_ - (bottom_ - top_) * plot_.y.axis.share(value);
  }

  // Places of the legend's entries, row by row; returns the number of rows.
  size_t layOutLegend() {
    double at = kLeft;
    size_t row = 0;
    for (const LegendEntry& entry : plot_.legend) {
      const double width = 22.0 + textWidth(entry.text, kFont) + 14.0;
      if (at + width > kWidth - 20.0) {
        at = kLeft;
        row++;
      }
      legendPlaces_.push_back({at, 42.0 + 18.0 * static_cast<double>(row) + 6.0});
      at += width;
    }
    return plot_.legend.empty() ? 0 : row + 1;
  }

  void drawLegend() {
    for (size_t i = 0; i < plot_.legend.size(); i++) {
      const LegendEntry& entry = plot_.legend[i];
      const auto [left, middle] = legendPlaces_[i];
      svg_ += entry.isLine ? segment("front", left - 4, middle, left + 16, middle)
                           : mark(entry.style, left + 6, middle, kRadius);
      svg_ += text(left + 20, middle + 4, "", entry.text);
    }
  }

  void drawXAxis() {
    const double end = bottom_ + zeroBand_;
    double lastTextEnd = -1.0;
    for (const Tick& tick : plot_.x.axis.ticks()) {
      const double at = x(tick.value);
      svg_ += segment(tick.text.empty() ? "fine" : "grid", at, top_, at, end);
      const double half = 0.5 * textWidth(tick.text, kFont);
      if (tick.text.empty() || at - half < lastTextEnd + 4.0) continue;
      svg_ += text(at, end + 17, "tick middle", tick.text);
      lastTextEnd = at + half;
    }
    svg_ += text(0.5 * (kLeft + right_), kHeight - 12, "axis middle", plot_.x.text);
    svg_ += segment("frame", kLeft, end, right_, end);
  }

  void drawYAxis() {
    for (const Tick& tick : plot_.y.axis.ticks()) {
      const double at = y(tick.value);
      svg_ += segment(tick.text.empty() ? "fine" : "grid", kLeft, at, right_, at);
      if (!tick.text.empty()) svg_ += text(kLeft - 8, at + 4, "tick end", tick.text);
    }
    if (zeroBand_ > 0.0) {
      svg_ += segment("grid", kLeft, y(0.0), right_, y(0.0));
      svg_ += text(kLeft - 8, y(0.0) + 4, "tick end", "0");
    }
    svg_ += rotated(22, plot_.y.text);
    if (!plot_.right) return;
    const double factor = plot_.right->factor;
    const Axis scale = Axis::logarithmic({plot_.y.axis.low() * factor, plot_.y.axis.high() * factor});
    for (const Tick& tick : scale.ticks()) {
      const double at = y(tick.value / factor);
      if (tick.text.empty() || at < top_ - 0.5 || at > bottom_ + 0.5) continue;
      svg_ += segment("frame", right_ - 5, at, right_, at) + text(right_ + 6, at + 4, "tick", tick.text);
    }
    svg_ += segment("frame", right_, top_, right_, bottom_);
    svg_ += rotated(kWidth - 10, plot_.right->text);
  }

  std::string rotated(double at, const std::string& content) const {
    const double middle = 0.5 * (top_ + bottom_);
    return fmt::format(R"svg(<text class="axis middle" transform="translate({:.1f} {:.1f}) rotate(-90)">{}</text>)svg",
                       at, middle, escapedXml(content));
  }

  void drawFront() {
    if (plot_.front.empty()) return;
    std::string path = fmt::format("M{:.1f} {:.1f}", x(plot_.front[0].x), top_);
    for (const PlotPoint& point : plot_.front) path += fmt::format("H{:.1f}V{:.1f}", x(point.x), y(point.y));
    svg_ += fmt::format(R"(<path class="front" d="{}H{:.1f}"/>)", path, right_);
  }

  void drawLine(const Line& line) {
    std::string path;
    for (const PlotPoint& point : line.points)
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x(point.x), y(point.y));
    if (line.points.size() > 1) svg_ += fmt::format(R"(<path class="line {}" d="{}"/>)", classOf(line.style), path);
    for (const PlotPoint& point : line.points)
      svg_ += mark(line.style, x(point.x), y(point.y), kRadius - 0.5,
                   fmt::format("{}: {} at {}", line.name, numberText(point.y), numberText(point.x)));
  }

  // At the right edge, at the height of each line's last point, moved apart.
  void drawLineNames() {
    if (plot_.right) return;
    std::vector<double> heights;
    std::vector<const Line*> named;
    for (const Line& line : plot_.lines) {
      if (line.points.empty()) continue;
      named.push_back(&line);
      heights.push_back(y(line.points.back().y));
    }
    const std::vector<double> spread = spreadApart(heights, kFont + 4.0, top_ + 4.0, bottom_ + zeroBand_ - 4.0);
    for (size_t i = 0; i < named.size(); i++) {
      svg_ += segment("leader", x(named[i]->points.back().x) + kRadius, heights[i], right_ + 4, spread[i]);
      svg_ += text(right_ + 8, spread[i] + 4, "strong " + classOf(named[i]->style), named[i]->name);
    }
  }

  // What labels should keep clear of.
  std::vector<Segment> drawnLines() const {
    std::vector<Segment> segments;
    double height = top_;
    for (size_t i = 0; i < plot_.front.size(); i++) {
      const double left = x(plot_.front[i].x);
      const double next = i + 1 < plot_.front.size() ? x(plot_.front[i + 1].x) : right_;
      segments.push_back({left, height, left, y(plot_.front[i].y)});
      height = y(plot_.front[i].y);
      segments.push_back({left, height, next, height});
    }
    for (const Line& line : plot_.lines) {
      for (size_t i = 1; i < line.points.size(); i++)
        segments.push_back(
            {x(line.points[i - 1].x), y(line.points[i - 1].y), x(line.points[i].x), y(line.points[i].y)});
    }
    return segments;
  }

  void drawMarks() {
    std::vector<LabelRequest> requests;
    for (const Mark& m : plot_.marks) requests.push_back({x(m.x), y(m.y), m.label, m.isMember});
    const Rect area{kLeft + 2, top_ + 2, right_ - kLeft - 4, bottom_ + zeroBand_ - top_ - 4};
    const auto placed = placeLabels(requests, area, drawnLines(), kFont, kRadius);
    for (size_t i = 0; i < requests.size(); i++) {
      if (placed[i] && placed[i]->leaderEnd)
        svg_ +=
            segment("leader", requests[i].x, requests[i].y, placed[i]->leaderEnd->first, placed[i]->leaderEnd->second);
    }
    for (size_t i = 0; i < requests.size(); i++)
      svg_ += mark(plot_.marks[i].style, requests[i].x, requests[i].y, kRadius, plot_.marks[i].tooltip);
    for (size_t i = 0; i < requests.size(); i++) {
      if (!placed[i]) continue;
      const Rect& rect = placed[i]->rect;
      const bool isLeft = rect.x + rect.width < requests[i].x;  // of its point: written up to it
      const bool isStrong = plot_.marks[i].isMember;
      const char* const classes =
          isLeft ? (isStrong ? "label strong end" : "label end") : (isStrong ? "label strong" : "label");
      svg_ += text(isLeft ? rect.x + rect.width : rect.x, rect.y + rect.height - 3.0, classes, requests[i].text);
    }
  }

  const Plot& plot_;
  double right_;
  double top_;
  double bottom_;
  double zeroBand_;
  size_t legendRows_;
  std::vector<std::pair<double, double>> legendPlaces_;
  std::string svg_;
};

}  // namespace

std::string plotSvg(const Plot& plot) { return PlotDrawing(plot).draw(); }

}  // namespace tetralux::chart
