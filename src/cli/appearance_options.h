// What is shown beside the volume, from the command line (docs/appearance.md).
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "volume/appearance.h"

namespace tetralux::cli {

// --iso, --clip, --no-volume.
struct AppearanceOptions {
  std::vector<std::string> isosurfaces;  // parseIsosurface(); instead of the scene's
  std::vector<std::string> clip;         // parseClipPlane(); added to the scene's
  bool noVolume = false;

  void add(CLI::App& app);
  // Changes what a scene says. Throws Error(Usage).
  void apply(Appearance& appearance) const;
};

// Parses "VALUE[:RGB[:OPACITY]]": RGB as six hexadecimal digits, sRGB (default e0e0e0); OPACITY from 0 to 1 (default
// 1). Throws Error(Usage).
Isosurface parseIsosurface(const std::string& text);

// Parses "NX,NY,NZ,OFFSET". Throws Error(Usage).
ClipPlane parseClipPlane(const std::string& text);

}  // namespace tetralux::cli
