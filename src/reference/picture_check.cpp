#include "reference/picture_check.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "image/metrics.h"
#include "reference/coverage.h"
#include "reference/pixel_sample.h"
#include "reference/share_bound.h"

namespace tetralux::reference {
namespace {

constexpr double kConfidence = 0.99;

bool isOver(const glm::vec4& exact, const glm::vec4& found, double tolerance) {
  for (int channel = 0; channel < 4; channel++) {
    // Not a number is over every tolerance.
    if (!(std::abs(static_cast<double>(exact[channel]) - static_cast<double>(found[channel])) <= tolerance))
      return true;
  }
  return false;
}

}  // namespace

PictureCheck checkPixels(const ReferenceScene& scene, const Image& picture, std::span<const PixelPosition> positions,
                         double tolerance) {
  PictureCheck check;
  check.pixels = positions.size();
  if (positions.empty()) return check;
  const ImageSize row{static_cast<std::uint32_t>(positions.size()), 1};
  const Image exact = toImage(renderPixels(scene, positions), row);
  Image found(row.width, row.height);
  for (size_t i = 0; i < positions.size(); i++) {
    found.pixels[i] = picture.at(positions[i].x, positions[i].y);
    check.over += isOver(exact.pixels[i], found.pixels[i], tolerance) ? 1 : 0;
  }
  const ImageDifference difference = compareImages(exact, found);
  check.rmse = difference.rmse;
  check.max = difference.max;
  check.p99 = difference.p99;
  return check;
}

PictureCheck checkPicture(const ReferenceScene& scene, const Image& picture, std::uint32_t count) {
  const std::vector<std::uint8_t> all(picture.pixels.size(), 1);
  return checkPixels(scene, picture, stratifiedPixels(scene.size, all, count, 1), 1.0);
}

Certificate certifyPicture(const ReferenceScene& scene, const Image& picture, std::uint32_t count, std::uint32_t seed,
                           double tolerance) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<std::uint8_t> covered = coveredPixels(scene, picture);
  Certificate certificate;
  certificate.tolerance = tolerance;
  certificate.coveredPixels = static_cast<std::uint64_t>(std::count(covered.begin(), covered.end(), 1));
  certificate.check = checkPixels(scene, picture, stratifiedPixels(scene.size, covered, count, seed), tolerance);
  const PictureCheck& check = certificate.check;
  if (check.pixels == certificate.coveredPixels)
    certificate.shareOverBound =
        static_cast<double>(check.over) / static_cast<double>(std::max<std::uint64_t>(check.pixels, 1));
  else
    certificate.shareOverBound = upperShareBound(check.over, check.pixels, kConfidence);
  certificate.ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return certificate;
}

}  // namespace tetralux::reference
