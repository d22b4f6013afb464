#include "cli/chart_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "chart/pareto.h"
#include "chart/svg_text.h"
#include "render/projection.h"

namespace tetralux::cli {
namespace {

using chart::Axis;
using chart::Plot;
using chart::Shape;

int projectionColor(const MeasuredRow& row) {
  return static_cast<int>(render::parseProjection(row.row.at("projection")));
}

// Which part of a configuration is not the default's; the method of integration where there is none or several.
struct Aspect {
  const char* key;
  const char* text;
  Shape shape;
};
constexpr Aspect kAspects[] = {{"tolerance", "tolerance", Shape::Cross},
                               {"interpolation", "interpolation", Shape::Diamond},
                               {"target", "target", Shape::Square},
                               {"order", "order", Shape::Triangle},
                               {"integration", "integration, or all by default", Shape::Circle}};

const Aspect& aspectOf(const Configuration& configuration) {
  for (const Aspect& aspect : kAspects) {
    if (configuration.value(aspect.key) != Configuration().value(aspect.key)) return aspect;
  }
  return kAspects[std::size(kAspects) - 1];
}

// Values of a column, of all rows.
std::vector<double> columnOf(const std::vector<const MeasuredRow*>& rows, const std::string& column) {
  std::vector<double> values;
  for (const MeasuredRow* row : rows) values.push_back(numberOf(row->row, column));
  return values;
}

std::vector<chart::LegendEntry> errorLegend(const std::vector<const MeasuredRow*>& rows) {
  std::vector<chart::LegendEntry> legend;
  for (size_t i = 0; i < render::projectionNames().size(); i++) {
    const auto isIt = [&](const MeasuredRow* row) { return projectionColor(*row) == static_cast<int>(i); };
    if (std::any_of(rows.begin(), rows.end(), isIt))
      legend.push_back({render::projectionNames()[i], {static_cast<int>(i), Shape::Circle}});
  }
  constexpr int kNeutral = chart::kColorCount - 1;
  for (const Aspect& aspect : kAspects) {
    const auto isIt = [&](const MeasuredRow* row) { return &aspectOf(row->measurement.configuration) == &aspect; };
    if (std::any_of(rows.begin(), rows.end(), isIt)) legend.push_back({aspect.text, {kNeutral, aspect.shape}});
  }
  legend.push_back({"Pareto front", {}, true});
  return legend;
}

// The name of a mark, without the projection that its colour tells, unless nothing else is left.
std::string markName(const Configuration& configuration) {
  const std::string& projection = configuration.value("projection");
  const std::string name = configuration.with("projection", Configuration().value("projection")).name();
  return name == "default" && projection != Configuration().value("projection") ? projection : name;
}

// Entries of a table of size "N", "NxM", "NxMxL".
double entryCount(const std::string& size) {
  double count = 1.0;
  for (size_t at = 0; at < size.size();) {
    size_t end = std::min(size.find('x', at), size.size());
    count *= std::stod(size.substr(at, end - at));
    at = end + 1;
  }
  return count;
}

// Of marks with the same label, one above the other, only the highest keeps it.
void labelHighestOnly(std::vector<chart::Mark>& marks) {
  std::stable_sort(marks.begin(), marks.end(), [](const auto& a, const auto& b) { return a.y > b.y; });
  for (auto mark = marks.begin(); mark != marks.end(); ++mark) {
    const auto isSame = [&](const chart::Mark& m) { return m.label == mark->label; };
    if (std::any_of(marks.begin(), mark, isSame)) mark->label.clear();
  }
}

void sortByX(std::vector<chart::PlotPoint>& points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
}

}  // namespace

double numberOf(const chart::CsvRow& row, const std::string& column) {
  const auto found = row.find(column);
  double value = std::numeric_limits<double>::quiet_NaN();
  if (found != row.end()) std::from_chars(found->second.data(), found->second.data() + found->second.size(), value);
  return value;
}

std::vector<const MeasuredRow*> rowsOf(const std::vector<MeasuredRow>& rows, size_t scene,
                                       std::initializer_list<MeasurementKind> kinds) {
  std::vector<const MeasuredRow*> found;
  for (const MeasuredRow& row : rows) {
    const bool isKind = std::find(kinds.begin(), kinds.end(), row.measurement.kind) != kinds.end();
    const auto note = row.row.find("note");
    const bool isMeasured = note == row.row.end() || note->second.empty();
    if (row.measurement.scene == scene && isKind && isMeasured) found.push_back(&row);
  }
  return found;
}

std::optional<ErrorChart> errorAgainstTime(const std::vector<MeasuredRow>& rows, size_t scene,
                                           const std::string& sceneName) {
  const auto pictures = rowsOf(rows, scene, {MeasurementKind::Picture});
  if (pictures.empty()) return std::nullopt;
  ErrorChart chart;
  std::vector<chart::Cost> costs;
  for (const MeasuredRow* row : pictures) costs.push_back({numberOf(row->row, "ms_frame"), numberOf(row->row, "rmse")});
  const std::vector<size_t> front = chart::paretoFront(costs);
  Plot& plot = chart.plot;
  plot.title = sceneName + ": error against time";
  plot.x = {"ms per frame", Axis::logarithmic(columnOf(pictures, "ms_frame"))};
  plot.y = {"RMSE against the exact picture", Axis::logarithmic(columnOf(pictures, "rmse"))};
  for (size_t i = 0; i < pictures.size(); i++) {
    const Configuration& configuration = pictures[i]->measurement.configuration;
    chart::Mark mark;
    mark.x = costs[i].x;
    mark.y = costs[i].y;
    mark.style = {projectionColor(*pictures[i]), aspectOf(configuration).shape};
    mark.label = markName(configuration);
    mark.tooltip = fmt::format("{}: {:.4g} ms, RMSE {:.3g}", configuration.name(), mark.x, mark.y);
    mark.isMember = std::find(front.begin(), front.end(), i) != front.end();
    plot.marks.push_back(mark);
  }
  for (const size_t i : front) {
    plot.front.push_back({costs[i].x, costs[i].y});
    chart.front.push_back(pictures[i]);
  }
  plot.legend = errorLegend(pictures);
  return chart;
}

std::optional<Plot> errorAgainstTableSize(const std::vector<MeasuredRow>& rows, size_t scene,
                                          const std::string& sceneName) {
  Plot plot;
  plot.title = sceneName + ": error against table size";
  std::vector<double> entries;
  std::vector<double> errors;
  for (const MeasuredRow* row : rowsOf(rows, scene, {MeasurementKind::Error})) {
    const std::string& size = row->row.at("table-size");
    if (size.empty()) continue;
    const std::string& method = row->row.at("integration");
    auto line = std::find_if(plot.lines.begin(), plot.lines.end(), [&](const auto& l) { return l.name == method; });
    if (line == plot.lines.end()) {
      const int index = static_cast<int>(plot.lines.size());
      plot.lines.push_back({method, {index, static_cast<Shape>(index % chart::kShapeCount)}, {}});
      line = plot.lines.end() - 1;
    }
    entries.push_back(entryCount(size));
    errors.push_back(numberOf(row->row, "rmse"));
    line->points.push_back({entries.back(), errors.back()});
  }
  if (plot.lines.empty()) return std::nullopt;
  for (chart::Line& line : plot.lines) sortByX(line.points);
  plot.x = {"table entries", Axis::logarithmic(entries)};
  plot.y = {"RMSE against the exact picture", Axis::logarithmic(errors)};
  return plot;
}

std::optional<Plot> rateAgainstImageSize(const std::vector<MeasuredRow>& rows, size_t scene,
                                         const std::string& sceneName) {
  Plot plot;
  std::vector<double> rates;
  std::vector<chart::Tick> sides;
  double cells = 0.0;
  for (size_t i = 0; i < render::projectionNames().size(); i++) {
    const std::string& projection = render::projectionNames()[i];
    chart::Line line{projection, {static_cast<int>(i), static_cast<Shape>(i % chart::kShapeCount)}, {}};
    for (const MeasuredRow* row : rowsOf(rows, scene, {MeasurementKind::Time})) {
      if (row->measurement.side == 0 || row->row.at("projection") != projection) continue;
      const double side = row->measurement.side;
      line.points.push_back({side, numberOf(row->row, "tets_per_s")});
      rates.push_back(line.points.back().y);
      cells = numberOf(row->row, "cells");
      if (std::none_of(sides.begin(), sides.end(), [&](const chart::Tick& t) { return t.value == side; }))
        sides.push_back({side, fmt::format("{}", row->measurement.side)});
    }
    sortByX(line.points);
    if (line.points.empty()) continue;
    plot.legend.push_back({projection, line.style});
    plot.lines.push_back(std::move(line));
  }
  if (plot.lines.empty()) return std::nullopt;
  plot.title = sceneName + ": speed against image size";
  plot.x = {"side of the square image, pixels", Axis::logarithmicAt(sides)};
  plot.y = {"tets per second", Axis::logarithmic(rates)};
  plot.right = chart::RightScale{"frames per second", 1.0 / cells};
  return plot;
}

std::optional<Plot> rateAgainstCells(const ChartPlan& plan, const std::vector<MeasuredRow>& rows,
                                     const std::string& column, const std::string& title, const std::string& yText) {
  Plot plot;
  plot.title = title;
  std::vector<double> cells;
  std::vector<double> rates;
  for (size_t i = 0; i < render::projectionNames().size(); i++) {
    const std::string& projection = render::projectionNames()[i];
    const chart::Style style{static_cast<int>(i), static_cast<Shape>(i % chart::kShapeCount)};
    chart::Line line{projection, style, {}};
    for (size_t scene = 0; scene < plan.scenes.size(); scene++) {
      for (const MeasuredRow* row : rowsOf(rows, scene, {MeasurementKind::Time})) {
        if (row->measurement.side != 0 || row->row.at("projection") != projection) continue;
        const chart::PlotPoint point{numberOf(row->row, "cells"), numberOf(row->row, column)};
        cells.push_back(point.x);
        rates.push_back(point.y);
        if (plan.scenes[scene].path.empty()) {
          line.points.push_back(point);
          continue;
        }
        const std::string& name = plan.scenes[scene].name;
        const std::string tooltip = fmt::format("{}, {}: {}", name, projection, chart::numberText(point.y));
        plot.marks.push_back({point.x, point.y, style, name, tooltip, false});
      }
    }
    sortByX(line.points);
    if (!line.points.empty()) plot.lines.push_back(std::move(line));
    plot.legend.push_back({projection, style});
  }
  if (rates.empty()) return std::nullopt;
  labelHighestOnly(plot.marks);
  plot.x = {"cells", Axis::logarithmic(cells)};
  plot.y = {yText, Axis::logarithmic(rates)};
  return plot;
}

}  // namespace tetralux::cli
