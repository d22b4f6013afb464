// The scene file: what is drawn, from where, in which colours.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "view/camera.h"
#include "volume/appearance.h"
#include "volume/transfer_function.h"

namespace tetralux {

inline constexpr std::uint32_t kLargestImageSide = 65536;  // pixels; above what any device's attachments hold

struct Scene {
  std::filesystem::path meshPath;  // absolute, or relative to the working directory
  std::string fieldName;           // point or cell array
  Camera camera;
  ImageSize size;
  glm::dvec3 background{0.0};  // linear rgb, only composited where the output has no alpha
  TransferFunction transferFunction;
  Appearance appearance;
};

// Reads a scene. A relative mesh path is taken from the scene file's folder. The mesh is not opened.
// Throws Error(Input) that names the place: an unknown or missing key, a value of the wrong kind or out of range.
Scene readScene(const std::filesystem::path& path);

// The same from text; `place` stands for the file's name, `folder` for the folder that a relative mesh path starts at.
Scene parseScene(std::string_view text, const std::string& place, const std::filesystem::path& folder);

// A camera by itself: {"camera": {...}} in a file (a scene file serves as well).
Camera readCamera(const std::filesystem::path& path);

}  // namespace tetralux
