#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <map>

#include "base/error.h"
#include "base/files.h"
#include "base/progress.h"
#include "chart/thumbnail.h"
#include "cli/chart_measure.h"
#include "cli/chart_report.h"
#include "cli/commands.h"

namespace tetralux::cli {
namespace {

namespace fs = std::filesystem;

// A folder that exists from now on. Throws Error(Output).
void makeFolder(const fs::path& path) {
  std::error_code ec;
  fs::create_directories(path, ec);
  if (ec || !fs::is_directory(path))
    fail(ErrorCode::Output, "--out: {}: cannot be made: {}", path.string(), ec ? ec.message() : "is not a folder");
}

// The picture as it is shown, with nothing transparent.
Image over(const Image& image, const glm::dvec3& background) {
  Image result = image;
  for (glm::vec4& pixel : result.pixels)
    pixel = glm::vec4(glm::vec3(pixel) + (1.0f - pixel.a) * glm::vec3(background), 1.0f);
  return result;
}

// Of rows with the same key the last one: it was measured because the others do not hold.
chart::CsvTable withoutSuperseded(const chart::CsvTable& table) {
  std::map<std::string, size_t> last;
  for (size_t i = 0; i < table.rows.size(); i++) last[table.rows[i].at("key")] = i;
  chart::CsvTable result{table.columns, {}};
  for (size_t i = 0; i < table.rows.size(); i++) {
    if (last[table.rows[i].at("key")] == i) result.rows.push_back(table.rows[i]);
  }
  return result;
}

class ChartCommand : public Command {
 public:
  explicit ChartCommand(CLI::App& app) : app_(app) {
    app.add_option("scenes", plan_.scenes, "Scenes (.json) or meshes (.vtu, .vtk)")->required()->type_name("SCENE...");
    app.add_option("--out", out_, "Folder for measurements.csv, the charts, report.html and pictures")
        ->required()
        ->type_name("DIR");
    app.add_option(
           "--configuration", plan_.configurations,
           "Draw so instead of in the default ways: KEY=VALUE,..., keys are options' names without dashes; may be "
           "repeated")
        ->type_name("KEY=VALUE,...")
        ->take_all();
    app.add_option("--set", plan_.sets,
                   "Measure this part only; may be repeated (default: all; with --configuration: "
                   "segments)")
        ->check(CLI::IsMember(chartSetNames()));
    app.add_option("--cells", cells_, "Sizes of generated meshes, N,N,... (default: 1000,10000,100000,1000000)")
        ->delimiter(',')
        ->check(CLI::Range(std::uint64_t{1000}, std::uint64_t{100000000}));
    app.add_option("--frames", frames_, "Frames timed at most; the camera turns by one degree a frame (default: 5)")
        ->check(CLI::Range(1u, 100000u));
    app.add_option("--thumbnail", thumbnail_, "Longest side of a picture in the report, pixels (default: 256)")
        ->check(CLI::Range(16u, 4096u));
    app.add_flag("--fresh", fresh_, "Measure everything again; without it, what DIR holds is not measured twice");
    sceneOptions_.add(app);
    deviceOptions_.addDevice(app);
    addQuiet(app);
  }

  int run() override {
    if (!sceneOptions_.size.empty()) parseSize(sceneOptions_.size);
    plan_.cells = cells_;
    const ChartPlan plan = makeChartPlan(plan_);
    const fs::path folder = out_;
    makeFolder(folder / "pictures");
    const gpu::Context context(deviceOptions_.contextOptions());
    chart::CsvFile file = openMeasurements(folder / "measurements.csv");
    ChartReport report{plan,
                       {},
                       std::vector<ReportScene>(plan.scenes.size()),
                       context.info().name,
                       context.info().driver,
                       versionString(),
                       commandLine(),
                       thumbnail_};
    measureAll(context, folder / "pictures", file, report);
    writeFile(folder / "measurements.csv", chart::csvText(withoutSuperseded(file.table())));
    writeChartReport(report, folder, folder / "pictures");
    spdlog::info("wrote {}", (folder / "report.html").string());
    return 0;
  }

 private:
  // The rows of earlier runs under today's columns.
  chart::CsvFile openMeasurements(const fs::path& path) const {
    chart::CsvTable table;
    if (!fresh_ && fs::exists(path) && fs::file_size(path) > 0)
      table = chart::parseCsv(readTextFile(path), path.string());
    table.columns = measurementColumns();
    for (const chart::CsvRow& row : table.rows) {
      for (const char* column : {"key", "note"}) {
        if (!row.contains(column))
          fail(ErrorCode::Input, "{}: line 1: no column '{}', expected a file that chart wrote, or --fresh",
               path.string(), column);
      }
    }
    return chart::CsvFile(path, withoutSuperseded(table));
  }

  void measureAll(const gpu::Context& context, const fs::path& pictures, chart::CsvFile& file,
                  ChartReport& report) const {
    // A row with a note is no result: what is refused today may be drawn by a later build.
    std::map<std::string, chart::CsvRow> finished;
    for (const chart::CsvRow& row : file.table().rows) {
      if (row.at("note").empty()) finished[row.at("key")] = row;
    }
    ChartMeasurer measurer(context, pictures, frames_);
    std::optional<LoadedChartScene> loaded;
    std::optional<size_t> loadedIndex;
    size_t skipped = 0;
    Progress progress("chart", report.plan.measurements.size());
    for (const Measurement& measurement : report.plan.measurements) {
      const ChartScene& scene = report.plan.scenes[measurement.scene];
      if (loadedIndex != measurement.scene) {
        loaded.emplace(scene, sceneOptions_, pictures);
        loadedIndex = measurement.scene;
        measurer.setScene(scene, *loaded);
        report.scenes[measurement.scene].size = loaded->loaded().scene.size;
      }
      const std::vector<std::string> files = measurer.pictureFiles(measurement);
      const auto done = finished.find(measurer.key(measurement));
      const bool hasPictures =
          std::all_of(files.begin(), files.end(), [&](const std::string& name) { return fs::exists(pictures / name); });
      if (done != finished.end() && hasPictures) {
        report.rows.push_back({measurement, done->second});
        skipped++;
      } else {
        report.rows.push_back({measurement, measurer.measure(measurement)});
        file.append(report.rows.back().row);
      }
      if (!files.empty() && !report.scenes[measurement.scene].exact)
        report.scenes[measurement.scene].exact = over(loaded->exactPicture().image, loaded->loaded().scene.background);
      progress.advance();
    }
    if (skipped > 0) spdlog::info("{} of {} measurements were there", skipped, report.plan.measurements.size());
  }

  // As it was given, in the order of --help, with nothing that only this machine has: folders of absolute paths and of
  // scenes are left out, and so is what does not change a result.
  std::string commandLine() const {
    std::string line = "tetralux chart";
    for (const std::string& scene : plan_.scenes) line += " " + fs::path(scene).filename().string();
    for (const CLI::Option* option : app_.get_options()) {
      const std::string name = option->get_name();
      if (option->count() == 0 || !name.starts_with("--") || name == "--quiet" || name == "--fresh" || name == "--help")
        continue;
      for (const std::string& value : option->results()) {
        const fs::path path = value;
        line += " " + name;
        if (option->get_type_size() > 0) line += " " + (path.is_absolute() ? path.filename().string() : value);
      }
    }
    return line;
  }

  CLI::App& app_;
  PlanOptions plan_;
  std::vector<std::uint64_t> cells_ = {1000, 10000, 100000, 1000000};
  std::string out_;
  std::uint32_t frames_ = 5;
  std::uint32_t thumbnail_ = 256;
  bool fresh_ = false;
  SceneOptions sceneOptions_;
  DeviceOptions deviceOptions_;
};

}  // namespace

std::unique_ptr<Command> makeChartCommand(CLI::App& app) { return std::make_unique<ChartCommand>(app); }

}  // namespace tetralux::cli
