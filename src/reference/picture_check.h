// Whether a picture is right: some of its pixels against the exact answer.
#pragma once

#include <cstdint>
#include <span>

#include "image/image.h"
#include "reference/ray_caster.h"

namespace tetralux::reference {

// Errors of the pixels compared, as in ImageDifference (image/metrics.h): over their four channels, a value that is not
// a number counts as a difference of 1.
struct PictureCheck {
  std::uint64_t pixels = 0;  // compared
  double rmse = 0.0;
  double max = 0.0;
  double p99 = 0.0;
  std::uint64_t over = 0;  // pixels with a channel off by more than the tolerance
};

// Recomputes pixels in double precision. Without positions everything is 0.
//   picture     of scene.size
//   tolerance   >= 0
PictureCheck checkPixels(const ReferenceScene& scene, const Image& picture, std::span<const PixelPosition> positions,
                         double tolerance);

// ... of `count` pixels spread evenly over the whole image, empty ones as well, with a fixed seed.
PictureCheck checkPicture(const ReferenceScene& scene, const Image& picture, std::uint32_t count);

// A picture's measured error, over the pixels that show anything.
struct Certificate {
  PictureCheck check;
  std::uint64_t coveredPixels = 0;  // of the picture (coveredPixels())
  double tolerance = 0.0;
  // With a confidence of 99 % no larger a share of the covered pixels is over the tolerance; the share itself where all
  // of them were compared.
  double shareOverBound = 0.0;
  double ms = 0.0;  // that this took

  // Whether no pixel compared is over the tolerance.
  bool holds() const { return check.over == 0; }
};

// Recomputes `count` of the covered pixels, stratified; all of them where there are fewer.
Certificate certifyPicture(const ReferenceScene& scene, const Image& picture, std::uint32_t count, std::uint32_t seed,
                           double tolerance);

}  // namespace tetralux::reference
