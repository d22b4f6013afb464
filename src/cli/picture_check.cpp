#include "cli/picture_check.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "reference/ray_caster.h"

namespace tetralux::cli {
namespace {

// One pixel at a random place in each of about `count` equal rectangles.
std::vector<reference::PixelPosition> stratifiedPixels(ImageSize size, std::uint32_t count) {
  const double aspect = static_cast<double>(size.width) / size.height;
  const auto columns =
      static_cast<std::uint32_t>(std::clamp(std::lround(std::sqrt(count * aspect)), 1l, static_cast<long>(size.width)));
  const std::uint32_t rows = std::clamp(count / columns, 1u, size.height);
  std::mt19937 random(1);
  std::vector<reference::PixelPosition> positions;
  const auto place = [&](std::uint32_t index, std::uint32_t parts, std::uint32_t side) {
    const auto low = static_cast<std::uint32_t>(std::uint64_t{index} * side / parts);
    const auto high = static_cast<std::uint32_t>(std::uint64_t{index + 1} * side / parts);
    return low + static_cast<std::uint32_t>(random() % (high - low));
  };
  for (std::uint32_t row = 0; row < rows; row++) {
    for (std::uint32_t column = 0; column < columns; column++) {
      const std::uint32_t x = place(column, columns, size.width);
      positions.push_back({x, place(row, rows, size.height)});
    }
  }
  return positions;
}

}  // namespace

PictureCheck checkPicture(const LoadedScene& loaded, const Camera& camera, const Image& image, std::uint32_t count) {
  const auto positions = stratifiedPixels(loaded.scene.size, count);
  const auto exact = reference::renderPixels(
      {loaded.mesh, loaded.field, loaded.scene.transferFunction, camera, loaded.scene.size}, positions);
  PictureCheck check;
  check.pixels = static_cast<std::uint32_t>(positions.size());
  double squares = 0.0;
  for (size_t i = 0; i < positions.size(); i++) {
    const glm::dvec4 expected(exact[i].light, exact[i].alpha);
    const glm::vec4& found = image.at(positions[i].x, positions[i].y);
    for (int channel = 0; channel < 4; channel++) {
      double difference = std::abs(expected[channel] - static_cast<double>(found[channel]));
      if (!std::isfinite(difference)) difference = 1.0;
      squares += difference * difference;
      check.max = std::max(check.max, difference);
    }
  }
  check.rmse = std::sqrt(squares / (4.0 * static_cast<double>(positions.size())));
  return check;
}

}  // namespace tetralux::cli
