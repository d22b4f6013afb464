#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "base/files.h"
#include "base/progress.h"
#include "cli/commands.h"
#include "cli/common_options.h"
#include "stability/failure_map.h"
#include "stability/outcome_table.h"

namespace tetralux::cli {
namespace {

class StabilityCommand : public Command {
 public:
  explicit StabilityCommand(CLI::App& app) {
    app.add_option("--out", out_, "Folder for stability.csv, stability.svg and stability.html, made if missing")
        ->required()
        ->type_name("DIR");
    app.add_option("--region", regions_, "Only this region (may be repeated; default: all)")->type_name("NAME");
    deviceOptions_.addDevice(app);
    addQuiet(app);
  }

  int run() override {
    const std::vector<stability::Region> wanted = wantedRegions();
    makeFolder();
    const gpu::Context context(deviceOptions_.contextOptions());
    const auto& methods = stability::methods();
    std::vector<stability::Outcome> outcomes;
    {
      Progress progress("stability", wanted.size());
      for (const stability::Region& region : wanted) {
        const auto found = stability::runRegion(context, region, methods);
        outcomes.insert(outcomes.end(), found.begin(), found.end());
        progress.advance();
      }
    }
    failOnValidationMessages();
    const std::filesystem::path folder(out_);
    writeFile(folder / "stability.csv", stability::outcomeCsv(outcomes));
    writeFile(folder / "stability.svg", stability::failureMapSvg(outcomes, context.info().name));
    writeFile(folder / "stability.html", stability::failureMapHtml(outcomes, context.info().name));
    return report(outcomes);
  }

 private:
  std::vector<stability::Region> wantedRegions() const {
    const auto& all = stability::regions();
    if (regions_.empty()) return all;
    std::vector<stability::Region> wanted;
    for (const std::string& name : regions_) {
      const auto region =
          std::find_if(all.begin(), all.end(), [&](const stability::Region& r) { return r.name == name; });
      if (region == all.end()) {
        std::string names;
        for (const stability::Region& r : all) names += (names.empty() ? "" : ", ") + r.name;
        fail(ErrorCode::Usage, "--region: found '{}', expected one of: {}", name, names);
      }
      wanted.push_back(*region);
    }
    return wanted;
  }

  void makeFolder() const {
    std::error_code error;
    std::filesystem::create_directories(out_, error);
    if (error) fail(ErrorCode::Output, "--out: {}: cannot be made: {}", out_, error.message());
  }

  // Prints every miss of a strict method as a line; the default's decide the exit status.
  static int report(const std::vector<stability::Outcome>& outcomes) {
    const auto& methods = stability::methods();
    std::string defaultMiss;
    for (size_t i = 0; i < outcomes.size(); i++) {
      const stability::Method& method = methods[i % methods.size()];
      const stability::Outcome& o = outcomes[i];
      if (!method.isStrict || !o.applies || o.keepsLimits()) continue;
      const std::string line = fmt::format(
          "{}: {}: RMSE {:.3g}, largest {:.3g}, {} not finite ({}), expected at most {:.3g}, {:.3g}, 0", o.region,
          o.method, o.rmse, o.largest, o.nonFinite, o.worstCase, stability::kLargestRmse, stability::kLargestError);
      fmt::print("{}\n", line);
      if (i % methods.size() == 0 && defaultMiss.empty()) defaultMiss = line;
    }
    std::fflush(stdout);
    if (!defaultMiss.empty()) fail(ErrorCode::Limit, "{}", defaultMiss);
    return 0;
  }

  std::string out_;
  std::vector<std::string> regions_;
  DeviceOptions deviceOptions_;
};

}  // namespace

std::unique_ptr<Command> makeStabilityCommand(CLI::App& app) { return std::make_unique<StabilityCommand>(app); }

}  // namespace tetralux::cli
