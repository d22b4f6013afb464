// A chart of points or lines over two axes, as SVG.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chart/axis.h"

namespace tetralux::chart {

enum class Shape { Circle, Square, Triangle, Diamond, Down, Cross };
constexpr int kShapeCount = 6;

// How something is drawn: colour (0 .. kColorCount - 1, taken modulo) and shape.
struct Style {
  int color = 0;
  Shape shape = Shape::Circle;
};

struct Mark {
  double x = 0.0;
  double y = 0.0;
  Style style;
  std::string label;      // beside it, where there is room; may be empty
  std::string tooltip;    // shown under the pointer
  bool isMember = false;  // of the front: labelled first and in bold
};

struct PlotPoint {
  double x = 0.0;
  double y = 0.0;
};

struct Line {
  std::string name;  // written at its right end, unless there is a scale
  Style style;
  std::vector<PlotPoint> points;
};

struct LegendEntry {
  std::string text;
  Style style;
  bool isLine = false;  // the front's dashes instead of a mark
};

struct AxisTitle {
  std::string text;
  Axis axis;
};

// A second scale at the right: what is `factor` times the left axis, which must be logarithmic.
struct RightScale {
  std::string text;
  double factor = 1.0;
};

struct Plot {
  std::string title;
  AxisTitle x;
  AxisTitle y;
  std::optional<RightScale> right;
  std::vector<Line> lines;
  std::vector<Mark> marks;
  std::vector<PlotPoint> front;  // a step line through these, ascending x, that bounds what no mark beats
  std::vector<LegendEntry> legend;
};

// An SVG of 960 x 560 pixels. On a logarithmic y axis values of 0 lie on a line of their own below it.
std::string plotSvg(const Plot& plot);

}  // namespace tetralux::chart
