#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "base/error.h"
#include "base/files.h"
#include "base/progress.h"
#include "cli/commands.h"
#include "cli/floor_report.h"
#include "cli/load_scene.h"
#include "cli/sequence_time.h"
#include "cli/stats_json.h"
#include "cli/timed_frames.h"
#include "reference/picture_check.h"

namespace tetralux::cli {
namespace {

class BenchCommand : public Command {
 public:
  explicit BenchCommand(CLI::App& app) {
    app.add_option("scenes", scenes_, "Scenes (.json) or meshes (.vtu, .vtk)")->required()->type_name("SCENE...");
    app.add_option("--frames", frames_, "Frames timed; the camera turns by one degree a frame (default: 9)")
        ->check(CLI::Range(1u, 100000u));
    app.add_option("--warmup", warmup_, "Frames drawn before, at least (default: 2)")->check(CLI::Range(0u, 100000u));
    app.add_option(
           "--warmup-ms", warmupMs_,
           "... for so many milliseconds, and until frames stop becoming faster or ten times as many have passed "
           "(default: 300; on processors 0, which waits for nothing)")
        ->check(CLI::Range(0.0, 1e6));
    app.add_option("--max-rmse", maxRmse_,
                   "No timing of a picture whose RMSE is above this (default: 5e-5); with --tolerance, the largest "
                   "error counts")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--check-pixels", checkPixels_, "Pixels compared with the exact answer first (default: 1000)")
        ->check(CLI::Range(1u, 1000000u));
    app.add_flag("--floor", floor_,
                 "Measure what the passes could cost at least: a copy of what they move, triangles of one colour, an "
                 "empty submission");
    app.add_flag("--sequence", sequence_,
                 "Measure by the host's clock how fast pictures arrive, one after the other and with the next begun");
    app.add_flag("--json", json_, "Print JSON: one array with an object per scene");
    app.add_option("--stats", statsFile_, "Write the same array to a file")->type_name("FILE.json");
    sceneOptions_.add(app);
    deviceOptions_.add(app);
    addQuiet(app);
  }

  int run() override {
    const gpu::Context context(deviceOptions_.contextOptions());
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    if (!json_) printHeader(context.info());
    for (const std::string& scene : scenes_) {
      all.push_back(benchScene(context, scene));
      if (json_) continue;
      printRow(all.back());
      if (floor_) printFloor(all.back()["floor"]);
      if (sequence_) printSequence(all.back()["sequence"]);
    }
    if (json_) fmt::print("{}\n", all.dump(1));
    if (!statsFile_.empty()) writeFile(statsFile_, all.dump(1) + "\n");
    return 0;
  }

 private:
  // What another transfer function takes besides the frame, ms: the median of nine changes.
  static double transferChangeMs(render::Renderer& renderer, const TransferFunction& transfer) {
    std::array<double, 9> ms;
    for (double& change : ms) {
      const auto begin = std::chrono::steady_clock::now();
      renderer.setTransferFunction(transfer);
      change = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    }
    std::nth_element(ms.begin(), ms.begin() + 4, ms.end());
    return ms[4];
  }

  nlohmann::ordered_json benchScene(const gpu::Context& context, const std::string& path) const {
    const LoadedScene loaded = loadScene(path, sceneOptions_);
    render::Renderer renderer(context, loaded.mesh, loaded.field, deviceOptions_.rendererOptions());
    renderer.setTransferFunction(loaded.scene.transferFunction);
    renderer.setAppearance(loaded.scene.appearance, loaded.appearanceData);
    render::RenderOptions options = deviceOptions_.renderOptions();
    options.timed = true;

    // A wrong picture is not worth a time.
    const Camera& first = loaded.scene.camera;
    RunStats run;
    renderer.draw(first, loaded.scene.size, options);
    renderer.readImage();
    run.firstFrameMs = millisecondsSinceStart();
    // The second is drawn as those that are timed: what is empty may have been cut out since.
    renderer.draw(first, loaded.scene.size, options);
    const Image image = renderer.readImage();
    failOnValidationMessages();
    const reference::PictureCheck check = reference::checkPicture(loaded.exact(first), image, checkPixels_);
    const std::optional<double> tolerance = deviceOptions_.toleranceValue();
    if (tolerance && !(check.max <= *tolerance))
      fail(ErrorCode::Limit, "{}: error {:.3g} over {} pixels, expected at most {:.3g}: not timed", path, check.max,
           check.pixels, *tolerance);
    if (!tolerance && !(check.rmse <= maxRmse_))
      fail(ErrorCode::Limit, "{}: RMSE {:.3g} over {} pixels, expected at most {:.3g}: not timed", path, check.rmse,
           check.pixels, maxRmse_);

    Progress progress("bench " + std::filesystem::path(path).stem().string(), frames_);
    const TimedTurn turn{warmup_, warmupMs_.value_or(defaultWarmupMs(context.info())), frames_};
    run.frames = timeTurn(renderer, first, loaded.scene.size, options, turn, [&] { progress.advance(); });
    failOnValidationMessages();
    nlohmann::ordered_json json = {{"scene", path}};
    json.update(statsJson(loaded, context.info(), renderer, run));
    json["transfer_ms"] = transferChangeMs(renderer, loaded.scene.transferFunction);
    json["check"] = {{"pixels", check.pixels}, {"rmse", check.rmse}, {"max", check.max}};
    if (floor_)
      json["floor"] = floorJson(context, renderer, first, loaded.scene.size, options, loaded.mesh.cellCount(),
                                loaded.mesh.pointCount(), run.frames);
    if (sequence_) json["sequence"] = sequenceJson(renderer, first, loaded.scene.size, options, frames_);
    return json;
  }

  static void printSequence(const nlohmann::ordered_json& j) {
    fmt::print("  a picture on the host every {:.2f} ms one after the other, {:.2f} ms with the next begun\n",
               j["alone_ms"].get<double>(), j["in_flight_ms"].get<double>());
  }

  static void printHeader(const gpu::DeviceInfo& device) {
    fmt::print("{} ({}), medians in ms\n", device.name, device.driver);
    fmt::print("{:<24} {:>10} {:>10} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9}\n", "scene",
               "tets", "drawn", "order", "frame", "cull", "order", "sort", "project", "raster", "enter", "march",
               "readback", "rmse");
  }

  static void printRow(const nlohmann::ordered_json& j) {
    const auto& ms = j["ms"];
    const auto time = [&](const char* name) { return ms[name].get<double>(); };
    fmt::print(
        "{:<24} {:>10} {:>10} {:>8} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.2f} "
        "{:>9.2e}\n",
        std::filesystem::path(j["scene"].get<std::string>()).stem().string(), j["tets"].get<std::uint64_t>(),
        j["drawn_tets"].get<std::uint64_t>(), j["order"].get<std::string>(), time("frame"), time("cull"),
        time("order") + time("check"), time("sort"), time("project"), time("raster") + time("apart"), time("enter"),
        time("march"), time("readback"), j["check"]["rmse"].get<double>());
    std::fflush(stdout);
  }

  std::vector<std::string> scenes_;
  std::uint32_t frames_ = 9;
  std::uint32_t warmup_ = 2;
  std::optional<double> warmupMs_;
  double maxRmse_ = 5e-5;
  std::uint32_t checkPixels_ = 1000;
  bool floor_ = false;
  bool sequence_ = false;
  bool json_ = false;
  std::string statsFile_;
  SceneOptions sceneOptions_;
  DeviceOptions deviceOptions_;
};

}  // namespace

std::unique_ptr<Command> makeBenchCommand(CLI::App& app) { return std::make_unique<BenchCommand>(app); }

}  // namespace tetralux::cli
