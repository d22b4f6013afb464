#include "cli/commands.h"
#include "cli/load_scene.h"
#include "cli/write_image.h"
#include "reference/ray_caster.h"

namespace tetralux::cli {
namespace {

class ReferenceCommand : public Command {
 public:
  explicit ReferenceCommand(CLI::App& app) {
    app.add_option("input", input_, "Scene (.json) or mesh (.vtu, .vtk)")->required()->type_name("SCENE");
    app.add_option("-o,--output", output_, "Picture to write: RGBA and `layers`, the number of cells each ray meets")
        ->required()
        ->type_name("FILE.exr");
    sceneOptions_.add(app);
    exrOptions_.add(app);
    addQuiet(app);
  }

  int run() override {
    checkImageName(output_, /*pngAllowed=*/false);
    ExrOptions exr = exrOptions_.exrOptions();
    const LoadedScene loaded = loadScene(input_, sceneOptions_);
    const Scene& scene = loaded.scene;
    const auto pixels = reference::renderPixels(loaded.exact(scene.camera));
    exr.attributes = {{"tetralux.version", versionString()},
                      {"tetralux.mesh", scene.meshPath.filename().string()},
                      {"tetralux.field", loaded.field.name},
                      {"tetralux.method", "reference"}};
    exr.extraChannelName = "layers";
    for (const reference::ReferencePixel& pixel : pixels) exr.extraChannel.push_back(static_cast<float>(pixel.layers));
    writeImage(reference::toImage(pixels, scene.size), output_, scene, scene.camera, exr);
    return 0;
  }

 private:
  std::string input_;
  std::string output_;
  SceneOptions sceneOptions_;
  ExrFormatOptions exrOptions_;
};

}  // namespace

std::unique_ptr<Command> makeReferenceCommand(CLI::App& app) { return std::make_unique<ReferenceCommand>(app); }

}  // namespace tetralux::cli
