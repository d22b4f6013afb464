#include "cli/chart_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "chart/bars.h"
#include "chart/false_color.h"
#include "chart/html_report.h"
#include "chart/svg_text.h"
#include "chart/thumbnail.h"
#include "cli/stats_json.h"
#include "image/image_io.h"

namespace tetralux::cli {
namespace {

std::string shortNumber(double value) { return std::isfinite(value) ? fmt::format("{:.2e}", value) : ""; }

std::string shortTime(double ms) {
  return !std::isfinite(ms) ? "" : ms < 10.0 ? fmt::format("{:.2f}", ms) : fmt::format("{:.1f}", ms);
}

// A picture with 99 % of its values this near to the exact ones is the same to eyes: half an 8-bit level.
constexpr double kVisible = 0.5 / 255.0;

std::string defaultsText() {
  std::string text;
  for (const std::string& key : Configuration::keys()) {
    const std::string value = Configuration().value(key);
    if (!value.empty()) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", key, value);
  }
  return text;
}

class ReportWriter {
 public:
  ReportWriter(const ChartReport& report, const std::filesystem::path& folder, const std::filesystem::path& pictures)
      : report_(report), folder_(folder), pictures_(pictures), html_("tetralux: speed against accuracy") {}

  void write() {
    writeIntroduction();
    for (size_t scene = 0; scene < report_.plan.scenes.size(); scene++) writeScene(scene);
    writeCells();
    writeSegments();
    writeFile(folder_ / "report.html", std::move(html_).finish());
  }

 private:
  const std::string& nameOf(size_t scene) const { return report_.plan.scenes[scene].name; }

  void writeIntroduction() {
    html_.paragraph(
        fmt::format("Drawn on {} ({}) by tetralux {}, with", report_.device, report_.driver, report_.version));
    html_.code(report_.commandLine);
    html_.paragraph(
        "Times are medians, ms of device work per frame with the camera turning by one degree a frame; they hold for "
        "this "
        "machine. Errors are those of the scene's own view against the exact picture, computed in double precision on "
        "the "
        "processor, over linear premultiplied RGBA; they do not depend on the machine's speed, and two runs on a "
        "device "
        "agree in them to the last digit. All numbers are in measurements.csv.");
  }

  void addChart(const std::string& file, const std::string& svg) {
    writeFile(folder_ / (file + ".svg"), svg);
    html_.chart(svg);
  }

  void writeScene(size_t scene) {
    const auto errors = errorAgainstTime(report_.rows, scene, nameOf(scene));
    const auto tables = errorAgainstTableSize(report_.rows, scene, nameOf(scene));
    const auto sizes = rateAgainstImageSize(report_.rows, scene, nameOf(scene));
    if (!errors && !tables && !sizes) return;
    const ImageSize size = report_.scenes[scene].size;
    html_.heading(fmt::format("{}, {} x {} pixels", nameOf(scene), size.width, size.height));
    if (errors) writeErrors(scene, *errors);
    if (tables) {
      html_.subheading("Error against table size");
      addChart(nameOf(scene) + "-table-size", chart::plotSvg(*tables));
    }
    if (sizes) {
      html_.subheading("Speed against image size");
      addChart(nameOf(scene) + "-image-size", chart::plotSvg(*sizes));
    }
    if (errors) writePictures(scene, *errors);
  }

  void writeErrors(size_t scene, const ErrorChart& errors) {
    addChart(nameOf(scene) + "-error-time", chart::plotSvg(errors.plot));
    std::string front;
    for (const MeasuredRow* row : errors.front)
      front += fmt::format("{}{} ({} ms, RMSE {})", front.empty() ? "" : "; ", row->measurement.configuration.name(),
                           shortTime(numberOf(row->row, "ms_frame")), shortNumber(numberOf(row->row, "rmse")));
    html_.paragraph(fmt::format(
        "On the Pareto front, fastest first (nothing measured is both quicker and closer): {}. Names say what "
        "differs from the defaults: {}.",
        front, defaultsText()));
    writeTable(scene, errors);
    writeRefusals(scene);
  }

  bool isMember(const ErrorChart& errors, const MeasuredRow* row) const {
    return std::find(errors.front.begin(), errors.front.end(), row) != errors.front.end();
  }

  std::vector<const MeasuredRow*> picturesByTime(size_t scene) const {
    auto rows = rowsOf(report_.rows, scene, {MeasurementKind::Picture});
    std::stable_sort(rows.begin(), rows.end(), [](const MeasuredRow* a, const MeasuredRow* b) {
      return numberOf(a->row, "ms_frame") < numberOf(b->row, "ms_frame");
    });
    return rows;
  }

  void writeTable(size_t scene, const ErrorChart& errors) {
    const auto rows = picturesByTime(scene);
    std::vector<std::string> passes;  // those that any row spends time in
    for (const std::string& pass : passNames()) {
      if (std::any_of(rows.begin(), rows.end(), [&](const auto* r) { return numberOf(r->row, "ms_" + pass) > 0.0; }))
        passes.push_back(pass);
    }
    chart::ReportTable table;
    table.header = {"configuration", "order, target drawn", "RMSE", "largest", "99th pct.", "FLIP", "ms"};
    table.header.insert(table.header.end(), passes.begin(), passes.end());
    table.textColumns = 2;
    for (const MeasuredRow* row : rows) {
      std::vector<std::string> cells = {row->measurement.configuration.name(),
                                        row->row.at("drawn_order") + ", " + row->row.at("drawn_target")};
      for (const char* error : {"rmse", "max", "p99", "flip"}) cells.push_back(shortNumber(numberOf(row->row, error)));
      cells.push_back(shortTime(numberOf(row->row, "ms_frame")));
      for (const std::string& pass : passes) {
        const double ms = numberOf(row->row, "ms_" + pass);
        cells.push_back(ms > 0.0 ? shortTime(ms) : "");
      }
      table.rows.push_back(std::move(cells));
      table.isStrong.push_back(isMember(errors, row));
    }
    html_.table(table);
  }

  void writeRefusals(size_t scene) {
    chart::ReportTable table;
    table.header = {"not drawn", "because"};
    table.textColumns = 2;
    for (const MeasuredRow& row : report_.rows) {
      if (row.measurement.scene != scene || row.measurement.kind != MeasurementKind::Picture) continue;
      const auto note = row.row.find("note");
      if (note != row.row.end() && !note->second.empty())
        table.rows.push_back({row.measurement.configuration.name(), note->second});
    }
    if (!table.rows.empty()) html_.table(table);
  }

  static std::string pngUri(const Image& image) {
    return chart::dataUri("image/png", encodePng(image, glm::vec3(0.0f), PngColors::Palette));
  }

  std::string keptUri(const std::string& file, chart::Shrink shrink) const {
    return pngUri(chart::thumbnail(readPng(pictures_ / file), report_.thumbnailSide, shrink));
  }

  void writePictures(size_t scene, const ErrorChart& errors) {
    const auto rows = picturesByTime(scene);
    html_.subheading("Pictures and differences");
    html_.paragraph(
        "Left the picture, right the largest difference of a pixel's four channels from the exact picture, in colours "
        "of "
        "this scale. A picture with 99 % of its values within half an 8-bit level of the exact ones looks like it, and "
        "is "
        "left out. Stars mark the Pareto front. Made smaller, a pixel of a difference image shows the largest of those "
        "that it stands for.");
    html_.chart(chart::differenceLegendSvg());
    std::vector<chart::ReportPicture> pictures;
    if (const auto& exact = report_.scenes[scene].exact)
      pictures.push_back({"exact", pngUri(chart::thumbnail(*exact, report_.thumbnailSide, chart::Shrink::Mean)), "",
                          "double precision"});
    for (const MeasuredRow* row : rows) {
      const std::string stem = nameOf(scene) + "-" + row->row.at("key");
      const bool isSeen = !(numberOf(row->row, "p99") <= kVisible);
      pictures.push_back({row->measurement.configuration.name(),
                          isSeen ? keptUri(stem + ".png", chart::Shrink::Mean) : "",
                          keptUri(stem + "-difference.png", chart::Shrink::Lightest),
                          fmt::format("RMSE {}, {} ms", shortNumber(numberOf(row->row, "rmse")),
                                      shortTime(numberOf(row->row, "ms_frame"))),
                          isMember(errors, row)});
    }
    html_.pictures(pictures);
  }

  void writeCells() {
    const auto rate =
        rateAgainstCells(report_.plan, report_.rows, "tets_per_s", "Tets per second against cells", "tets per second");
    const auto frames =
        rateAgainstCells(report_.plan, report_.rows, "fps", "Frame rate against cells", "frames per second");
    if (!rate || !frames) return;
    html_.heading("Speed against cells");
    html_.paragraph(
        "Lines run through generated meshes (tetralux mesh demo --cells N) that fill the picture alike; marks with "
        "names "
        "are the scenes.");
    addChart("cells-tets-per-second", chart::plotSvg(*rate));
    addChart("cells-frame-rate", chart::plotSvg(*frames));
  }

  void writeSegments() {
    chart::ReportTable table;
    table.header = {"scene",         "cells",  "cells after clipping", "growth", "segments on rays",
                    "linear pieces", "growth", "segments per ray"};
    std::vector<chart::Bar> bars;
    const auto growth = [](double base, double total) { return fmt::format("{:.1f} %", 100.0 * (total / base - 1.0)); };
    const auto count = [](double value) { return fmt::format("{:.0f}", value); };
    for (size_t scene = 0; scene < report_.plan.scenes.size(); scene++) {
      for (const MeasuredRow* row : rowsOf(report_.rows, scene, {MeasurementKind::Segments})) {
        const double cells = numberOf(row->row, "cells");
        const double cellPieces = numberOf(row->row, "cell_pieces");
        const double segments = numberOf(row->row, "segments");
        const double pieces = numberOf(row->row, "pieces");
        const double rays = numberOf(row->row, "width") * numberOf(row->row, "height");
        table.rows.push_back({nameOf(scene), count(cells), count(cellPieces), growth(cells, cellPieces),
                              count(segments), count(pieces), growth(segments, pieces),
                              fmt::format("{:.1f}", segments / rays)});
        bars.push_back({nameOf(scene), cells, cellPieces});
      }
    }
    if (bars.empty()) return;
    html_.heading("What control points cost");
    html_.paragraph(
        "Cells, and the parts that they fall into when each is clipped at every control point of the transfer function "
        "inside its "
        "range (Moreland and Angel 2004, table 1); and the same for the segments that the rays of all pixels have in "
        "cells, "
        "which is what the exact method integrates.");
    addChart("segments",
             chart::barsSvg("Cells that control points add", "cells", "added by clipping at control points", bars));
    html_.table(table);
  }

  const ChartReport& report_;
  const std::filesystem::path& folder_;
  const std::filesystem::path& pictures_;
  chart::HtmlReport html_;
};

}  // namespace

void writeChartReport(const ChartReport& report, const std::filesystem::path& folder,
                      const std::filesystem::path& pictures) {
  ReportWriter(report, folder, pictures).write();
}

}  // namespace tetralux::cli
