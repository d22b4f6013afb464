// From measured rows to charts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chart/csv.h"
#include "chart/plot.h"
#include "cli/chart_plan.h"

namespace tetralux::cli {

struct MeasuredRow {
  Measurement measurement;
  chart::CsvRow row;
};

// A value of a row as a number; NaN where it is empty or none.
double numberOf(const chart::CsvRow& row, const std::string& column);

// Rows of a scene and a kind that hold what they were measured for, in the order of the list.
std::vector<const MeasuredRow*> rowsOf(const std::vector<MeasuredRow>& rows, size_t scene,
                                       std::initializer_list<MeasurementKind> kinds);

struct ErrorChart {
  chart::Plot plot;
  std::vector<const MeasuredRow*> front;  // ascending time
};

// RMSE against ms per frame of a scene's pictures, with the Pareto front. Nothing without pictures.
std::optional<ErrorChart> errorAgainstTime(const std::vector<MeasuredRow>& rows, size_t scene,
                                           const std::string& sceneName);

// RMSE against the number of entries, for every method with a table. Nothing without such rows.
std::optional<chart::Plot> errorAgainstTableSize(const std::vector<MeasuredRow>& rows, size_t scene,
                                                 const std::string& sceneName);

// Cells per second, and frames per second at the right, against the side of a square image, per projection (Moreland
// and Angel 2004, figure 9). Nothing without such rows.
std::optional<chart::Plot> rateAgainstImageSize(const std::vector<MeasuredRow>& rows, size_t scene,
                                                const std::string& sceneName);

// `column` of the rows that were measured at the plan's image size against their cells, per projection: lines through
// generated meshes, marks for the scenes named. Nothing without such rows.
//   yText   what the column is
std::optional<chart::Plot> rateAgainstCells(const ChartPlan& plan, const std::vector<MeasuredRow>& rows,
                                            const std::string& column, const std::string& title,
                                            const std::string& yText);

}  // namespace tetralux::cli
