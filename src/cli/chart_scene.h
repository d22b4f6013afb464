// A scene that is being charted: loaded, known by its content, with its exact picture.
#pragma once

#include <optional>

#include "cli/chart_plan.h"
#include "cli/load_scene.h"
#include "image/image.h"

namespace tetralux::cli {

// Hexadecimal FNV-1a (Fowler, Noll, Vo; 64 bits) of bytes: a name for content, no protection against forgery.
std::string contentHash(std::string_view bytes);

// What decides how a scene looks: points, cells, field, transfer function, camera.
std::string sceneHash(const LoadedScene& loaded);

struct ExactPicture {
  Image image;
  std::uint64_t segments = 0;  // cells that the pixels' rays meet
  std::uint64_t pieces = 0;    // the same after cutting at control points
};

class LoadedChartScene {
 public:
  // Reads or generates the scene. Throws Error(Input).
  //   options   replace what the scene says
  //   folder    where exact pictures are kept
  LoadedChartScene(const ChartScene& scene, const SceneOptions& options, std::filesystem::path folder);

  const LoadedScene& loaded() const { return loaded_; }
  const std::string& hash() const { return hash_; }

  // In the scene's size; rendered once, then read from its file. Throws Error(Output) when it cannot be kept.
  const ExactPicture& exactPicture();

 private:
  std::optional<ExactPicture> readExact(const std::filesystem::path& path) const;
  ExactPicture renderExact(const std::filesystem::path& path) const;

  std::string name_;
  std::filesystem::path folder_;
  LoadedScene loaded_;
  std::string hash_;
  std::optional<ExactPicture> exact_;
};

}  // namespace tetralux::cli
