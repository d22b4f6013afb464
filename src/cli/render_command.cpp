#include <fmt/format.h>

#include <algorithm>
#include <future>

#include "base/error.h"
#include "base/files.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "base/task_queue.h"
#include "cli/certify_options.h"
#include "cli/commands.h"
#include "cli/frame_sequence.h"
#include "cli/frames_in_flight.h"
#include "cli/load_scene.h"
#include "cli/stats_json.h"
#include "cli/write_image.h"
#include "render/warm_pipelines.h"
#include "scene/scene_file.h"

namespace tetralux::cli {
namespace {

// Threads that encode and write pictures while the next are drawn. A GPU draws tens of pictures in the time that one
// takes; a processor that draws wants its cores for that.
unsigned writerCount(const gpu::DeviceInfo& device) {
  return device.isCpu ? 1 : std::clamp(workerCount() / 2, 1u, 16u);
}

class RenderCommand : public Command {
 public:
  explicit RenderCommand(CLI::App& app) {
    app.add_option("input", input_, "Scene (.json) or mesh (.vtu, .vtk)")->required()->type_name("SCENE|MESH");
    app.add_option("-o,--output", outputs_,
                   "Picture to write, .exr (linear) or .png (sRGB); may be repeated; %04d becomes the frame's number "
                   "(default: the input's name with .png, in this folder)")
        ->type_name("FILE");
    app.add_option("--frames", frames_, "Frames of a full turn about the camera's center (default: 1)")
        ->check(CLI::Range(1u, 1000000u));
    app.add_option("--stats", statsFile_, "Write statistics as JSON")->type_name("FILE.json");
    app.add_flag("--explain", explain_, "Print how the tolerance is kept: each decision, with the figure it rests on");
    certifyOptions_.add(app);
    sceneOptions_.add(app);
    deviceOptions_.add(app);
    exrOptions_.add(app);
    addQuiet(app);
  }

  int run() override {
    if (explain_ && deviceOptions_.tolerance.empty())
      fail(ErrorCode::Usage, "--explain: found no --tolerance, expected one: there is nothing to decide");
    certifyOptions_.settle(deviceOptions_.toleranceValue());
    const std::vector<FramePattern> patterns = outputPatterns();
    ExrOptions exr = exrOptions_.exrOptions();
    render::RenderOptions options = deviceOptions_.renderOptions();
    render::RendererOptions rendererOptions = deviceOptions_.rendererOptions();
    rendererOptions.checkOrder = !statsFile_.empty();
    // Vulkan starts while the mesh is read: neither needs the other, and each takes tens of milliseconds at least.
    auto starting = std::async(std::launch::async, [&] {
      Started started{std::make_unique<gpu::Context>(deviceOptions_.contextOptions()), nullptr};
      if (const auto frame = likelyFrame(options))
        started.pass = render::warmPipelines(*started.context, rendererOptions, *frame);
      return started;
    });
    LoadedScene loaded = loadScene(input_, sceneOptions_);
    Started started = starting.get();
    const gpu::Context& context = *started.context;
    render::Renderer renderer(context, loaded.mesh, loaded.field, rendererOptions, std::move(started.pass));
    if (certifyOptions_.count == 0) loaded.releaseMesh();
    renderer.setTransferFunction(loaded.scene.transferFunction);
    renderer.setAppearance(loaded.scene.appearance, loaded.appearanceData);
    options.timed = !statsFile_.empty();
    Certifier certifier(certifyOptions_);
    RunStats run;
    Progress progress("render", frames_);
    // A processor that draws is not disturbed while it is timed. One picture may wait, so that no writer need wait.
    const unsigned writers = writerCount(context.info());
    TaskQueue writing(options.timed && context.info().isCpu ? 0 : writers + 1, writers);
    const auto cameraOf = [&](std::uint32_t frame) { return loaded.scene.camera.turned(360.0 * frame / frames_); };
    const auto take = [&](std::uint32_t frame, render::Renderer::Finished finished) {
      const render::FrameStats& stats = finished.stats;
      const Camera camera = cameraOf(frame);
      const auto image = std::make_shared<const Image>(std::move(finished.image));
      failOnValidationMessages();
      exr.attributes = settings(loaded, context.info(), stats);
      const auto certificate = certifier.certify(loaded.exact(camera), *image);
      exr.attributes.insert(exr.attributes.end(), certificate.begin(), certificate.end());
      writing.push([&, image, frame, camera, exr] {
        for (const FramePattern& pattern : patterns) writeImage(*image, pattern.name(frame), loaded.scene, camera, exr);
        if (frame == 0) run.firstFrameMs = millisecondsSinceStart();
        progress.advance();
      });
      if (frame == 0 && explain_) printPlan(*stats.plan);
      run.frames.push_back(stats);
    };
    drawInFlight(renderer, frames_, loaded.scene.size, options, cameraOf, take);
    writing.finish();
    if (!statsFile_.empty()) {
      nlohmann::ordered_json json = statsJson(loaded, context.info(), renderer, run);
      json["certify"] = certifier.json();
      writeFile(statsFile_, json.dump(1) + "\n");
    }
    certifier.report(input_);
    return 0;
  }

 private:
  // What is made while the mesh is read.
  struct Started {
    std::unique_ptr<gpu::Context> context;
    std::unique_ptr<render::MarchPass> pass;
  };

  // What the scene file tells of the first frame; nothing where there is none, or more to show than a volume. Its
  // errors are loadScene()'s to report.
  std::optional<render::LikelyFrame> likelyFrame(const render::RenderOptions& options) const {
    if (!isSceneFile(input_)) return std::nullopt;
    try {
      Scene scene = readScene(input_);
      sceneOptions_.appearance.apply(scene.appearance);
      if (!scene.appearance.isPlain()) return std::nullopt;
      return render::LikelyFrame{scene.camera.projection, scene.transferFunction, options};
    } catch (const Error&) {
      return std::nullopt;
    }
  }

  std::vector<FramePattern> outputPatterns() const {
    std::vector<std::string> names = outputs_;
    if (names.empty())
      names.push_back(std::filesystem::path(input_).stem().string() + (frames_ > 1 ? "_%04d.png" : ".png"));
    std::vector<FramePattern> patterns;
    for (const std::string& name : names) {
      checkImageName(name, /*pngAllowed=*/true);
      patterns.emplace_back(name);
      if (frames_ > 1 && !patterns.back().hasNumber())
        fail(ErrorCode::Usage, "-o: found '{}', expected a place for the frame's number such as %04d with --frames {}",
             name, frames_);
    }
    return patterns;
  }

  static void printPlan(const render::TolerancePlan& plan) {
    fmt::print("tolerance    {:.4g} per pixel and channel\n", plan.tolerance);
    for (const render::ToleranceDecision& decision : plan.decisions)
      fmt::print("{:<12} {}: {:.3g}; {}\n", decision.what, decision.choice, decision.figure, decision.reason);
  }

  // What the picture's header says about how it was made.
  static std::vector<std::pair<std::string, std::string>> settings(const LoadedScene& loaded,
                                                                   const gpu::DeviceInfo& device,
                                                                   const render::FrameStats& stats) {
    return {{"tetralux.version", versionString()},
            {"tetralux.mesh", loaded.scene.meshPath.filename().string()},
            {"tetralux.field", loaded.field.name},
            {"tetralux.device", device.name},
            {"tetralux.driver", device.driver},
            {"tetralux.integration", render::integrationName(stats.integration)},
            {"tetralux.interpolation", render::interpolationName(stats.interpolation)},
            {"tetralux.projection", render::projectionName(stats.projection)},
            {"tetralux.order", render::orderName(stats.order.order)},
            {"tetralux.target", render::targetName(stats.target)}};
  }

  std::string input_;
  std::vector<std::string> outputs_;
  std::uint32_t frames_ = 1;
  std::string statsFile_;
  bool explain_ = false;
  CertifyOptions certifyOptions_;
  SceneOptions sceneOptions_;
  DeviceOptions deviceOptions_;
  ExrFormatOptions exrOptions_;
};

}  // namespace

std::unique_ptr<Command> makeRenderCommand(CLI::App& app) { return std::make_unique<RenderCommand>(app); }

}  // namespace tetralux::cli
