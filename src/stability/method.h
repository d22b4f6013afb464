// What is compared: the default configuration, and each of its parts replaced by each of the others.
#pragma once

#include <string>
#include <vector>

#include "render/renderer.h"

namespace tetralux::stability {

// Limits of a strict method in every region (RMSE over pixels and channels; largest per channel).
inline constexpr double kLargestRmse = 5e-5;
inline constexpr double kLargestError = 1.0 / 255.0;

struct Method {
  std::string axis;  // "default", "projection", "integration", "interpolation", "target" or "order"
  std::string name;  // of what is there instead of the default; "default"
  render::RendererOptions renderer;
  render::RenderOptions frame;
  bool isStrict = false;  // must keep the limits everywhere: exact integration, right order, 32-bit floats

  std::string fullName() const { return axis == name ? name : axis + " " + name; }
};

// The default first; methods that share a renderer follow each other.
const std::vector<Method>& methods();

}  // namespace tetralux::stability
