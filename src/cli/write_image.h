// Pictures to files, as the command line asks for them.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <string>

#include "image/image_io.h"
#include "scene/scene_file.h"

namespace tetralux::cli {

// --exr-type, --exr-compression
struct ExrFormatOptions {
  std::string type = "float";
  std::string compression = "zip";

  void add(CLI::App& app);
  // Throws Error(Usage) on a name that does not exist.
  ExrOptions exrOptions() const;
};

// Throws Error(Usage) unless the name ends in .exr or .png (when `pngAllowed`).
void checkImageName(const std::string& path, bool pngAllowed);

// EXR with the camera's matrices, or PNG over the scene's background, by the name's ending. Throws Error(Output).
void writeImage(const Image& image, const std::filesystem::path& path, const Scene& scene, const Camera& camera,
                ExrOptions exr);

}  // namespace tetralux::cli
