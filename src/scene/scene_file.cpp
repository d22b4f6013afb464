#include "scene/scene_file.h"

#include "base/error.h"
#include "base/files.h"
#include "scene/appearance_file.h"
#include "scene/json_object.h"
#include "scene/transfer_file.h"

namespace tetralux {
namespace {

Camera parseCamera(JsonObject object) {
  Camera camera;
  camera.projection = object.oneOf("projection", {"perspective", "orthographic"}) == 0 ? Projection::Perspective
                                                                                       : Projection::Orthographic;
  camera.eye = object.vec3("eye");
  camera.center = object.vec3("center");
  camera.up = object.vec3("up");
  if (camera.projection == Projection::Perspective)
    camera.fovyDegrees = object.number("fovy");
  else
    camera.heightWorld = object.number("height");
  object.finish();
  validate(camera, object.where());
  return camera;
}

}  // namespace

Scene parseScene(std::string_view text, const std::string& place, const std::filesystem::path& folder) {
  const nlohmann::json document = parseJson(text, place);
  JsonObject root(document, place, "");
  Scene scene;
  scene.meshPath = folder / root.text("mesh");  // an absolute path replaces the folder
  scene.fieldName = root.text("field");
  scene.camera = parseCamera(root.object("camera"));

  JsonObject image = root.object("image");
  scene.size.width = image.integer("width", 1, kLargestImageSide);
  scene.size.height = image.integer("height", 1, kLargestImageSide);
  if (image.has("background")) {
    scene.background = image.vec3("background");
    for (int i = 0; i < 3; i++) {
      if (!(scene.background[i] >= 0.0))
        fail(ErrorCode::Input, "{}[{}]: found {}, expected a number >= 0", image.where("background"), i,
             scene.background[i]);
    }
  }
  image.finish();

  scene.appearance = parseAppearance(root, folder);
  const bool isReplaced = scene.appearance.rgbaField || scene.appearance.transfer2d || !scene.appearance.volumeVisible;
  if (root.has("transfer_function") || !isReplaced)
    scene.transferFunction = parseTransferFunction(root.object("transfer_function"));
  root.finish();
  return scene;
}

Scene readScene(const std::filesystem::path& path) {
  return parseScene(readTextFile(path), path.string(), path.parent_path());
}

Camera readCamera(const std::filesystem::path& path) {
  const nlohmann::json document = parseJson(readTextFile(path), path.string());
  JsonObject root(document, path.string(), "");
  return parseCamera(root.object("camera"));
}

}  // namespace tetralux
