// Whether a picture is right: some of its pixels against the exact answer.
#pragma once

#include <cstdint>

#include "cli/load_scene.h"
#include "image/image.h"

namespace tetralux::cli {

struct PictureCheck {
  std::uint32_t pixels = 0;  // compared
  double rmse = 0.0;         // over their four channels
  double max = 0.0;
};

// Recomputes `count` pixels, spread evenly over the image with a fixed seed, in double precision.
PictureCheck checkPicture(const LoadedScene& loaded, const Camera& camera, const Image& image, std::uint32_t count);

}  // namespace tetralux::cli
