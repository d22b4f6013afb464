// From the command line's SCENE|MESH to everything that a picture needs.
#pragma once

#include <filesystem>
#include <string>

#include "cli/common_options.h"
#include "fields/appearance_data.h"
#include "mesh/tet_mesh.h"
#include "reference/ray_caster.h"
#include "scene/scene_file.h"

namespace tetralux::cli {

struct LoadedScene {
  Scene scene;
  TetMesh mesh;
  ScalarField field;
  AppearanceData appearanceData;
  double loadMs = 0.0;

  // What the exact answer is asked for. Refers to this and to the camera.
  reference::ReferenceScene exact(const Camera& camera) const {
    return {mesh, field, scene.transferFunction, camera, scene.size, &scene.appearance, &appearanceData};
  }

  // Frees the mesh and the field's values: a renderer has its own, and no exact answer will be asked for.
  void releaseMesh() {
    mesh = {};
    field.values = {};
  }
};

// Whether a name is that of a scene (.json) and not of a mesh.
bool isSceneFile(const std::filesystem::path& path);

// `path` is a scene (.json) or a mesh (any other name). For a bare mesh the camera shows it all, the field is its first
// scalar, and the transfer function is the one of defaultTransfer(). Options replace what the scene says.
// Throws Error(Input) or Error(Usage).
LoadedScene loadScene(const std::string& path, const SceneOptions& options);

}  // namespace tetralux::cli
