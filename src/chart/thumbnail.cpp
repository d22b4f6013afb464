#include "chart/thumbnail.h"

#include <algorithm>

#include "base/check.h"

namespace tetralux::chart {

Image thumbnail(const Image& image, std::uint32_t side, Shrink shrink) {
  CHECK_LT(0u, side);
  const std::uint32_t block = (std::max(image.width, image.height) + side - 1) / side;
  if (block <= 1) return image;
  const auto parts = [&](std::uint32_t pixels) { return (pixels + block - 1) / block; };
  Image result(parts(image.width), parts(image.height));
  const auto sum = [](const glm::vec4& p) { return p.x + p.y + p.z; };
  for (std::uint32_t y = 0; y < result.height; y++) {
    for (std::uint32_t x = 0; x < result.width; x++) {
      glm::vec4 total(0.0f);
      glm::vec4 lightest(0.0f, 0.0f, 0.0f, 1.0f);
      float count = 0.0f;
      for (std::uint32_t v = y * block; v < std::min((y + 1) * block, image.height); v++) {
        for (std::uint32_t u = x * block; u < std::min((x + 1) * block, image.width); u++) {
          const glm::vec4& pixel = image.at(u, v);
          total += pixel;
          count += 1.0f;
          if (sum(pixel) > sum(lightest)) lightest = pixel;
        }
      }
      result.at(x, y) = shrink == Shrink::Mean ? total / count : lightest;
    }
  }
  return result;
}

}  // namespace tetralux::chart
