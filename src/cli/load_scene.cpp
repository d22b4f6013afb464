#include "cli/load_scene.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cctype>
#include <chrono>

#include "base/error.h"
#include "cli/default_transfer.h"
#include "fields/appearance_data.h"
#include "mesh/curve_order.h"
#include "mesh/mesh_io.h"
#include "scene/transfer_file.h"

namespace tetralux::cli {
namespace {

constexpr ImageSize kDefaultSize{1024, 768};

// A mesh that is larger than caches and whose neighbours lie farther apart than this (memorySpread()) is put in order.
constexpr size_t kCacheCells = 100000;
constexpr double kLargestSpread = 0.15;

}  // namespace

bool isSceneFile(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension == ".json";
}

LoadedScene loadScene(const std::string& path, const SceneOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  LoadedScene loaded;
  const bool isScene = isSceneFile(path);
  if (isScene) loaded.scene = readScene(path);
  Scene& scene = loaded.scene;
  if (!isScene) {
    scene.meshPath = path;
    scene.size = kDefaultSize;
  }
  // Everything small is checked before the mesh, which may take minutes.
  if (!options.size.empty()) scene.size = parseSize(options.size);
  if (!options.field.empty()) scene.fieldName = options.field;
  if (!options.cameraFile.empty()) scene.camera = readCamera(options.cameraFile);
  const bool isPreset = transferPreset(options.transfer).has_value();
  if (!options.transfer.empty() && !isPreset) scene.transferFunction = readTransferFunction(options.transfer);

  options.appearance.apply(scene.appearance);

  loaded.mesh = readMesh(scene.meshPath);
  if (loaded.mesh.cellCount() >= kCacheCells && memorySpread(loaded.mesh) > kLargestSpread) {
    spdlog::info("{}: points and cells are scattered over the file; ordered along a Hilbert curve",
                 scene.meshPath.string());
    orderAlongCurve(loaded.mesh);
  }
  loaded.field = scalarField(loaded.mesh, scene.fieldName, scene.meshPath.string());
  scene.fieldName = loaded.field.name;
  loaded.appearanceData = makeAppearanceData(scene.appearance, loaded.mesh, loaded.field, scene.meshPath.string());
  if (isPreset || (!isScene && options.transfer.empty()))
    scene.transferFunction = defaultTransfer(loaded.mesh, loaded.field, options.transfer);
  if (options.opacityScale != 1.0) scene.transferFunction = scene.transferFunction.scaled(options.opacityScale);
  if (!isScene && options.cameraFile.empty()) {
    std::vector<glm::dvec3> points(loaded.mesh.pointCount());
    for (size_t i = 0; i < points.size(); i++) points[i] = loaded.mesh.point(i);
    scene.camera = framingCamera(points, scene.size);
  }
  loaded.loadMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  spdlog::info("{}: {} cells, {} points, field '{}' from {} to {}", scene.meshPath.string(), loaded.mesh.cellCount(),
               loaded.mesh.pointCount(), loaded.field.name, loaded.field.low, loaded.field.high);
  return loaded;
}

}  // namespace tetralux::cli
