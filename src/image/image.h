// A picture in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

namespace tetralux {

// Linear RGBA, premultiplied by alpha = 1 - transmittance. Row 0 is the top row, pixels row by row.
struct Image {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<glm::vec4> pixels;  // width * height

  Image() = default;
  Image(std::uint32_t w, std::uint32_t h) : width(w), height(h), pixels(static_cast<size_t>(w) * h, glm::vec4(0.0f)) {}

  glm::vec4& at(std::uint32_t x, std::uint32_t y) { return pixels[static_cast<size_t>(y) * width + x]; }
  const glm::vec4& at(std::uint32_t x, std::uint32_t y) const { return pixels[static_cast<size_t>(y) * width + x]; }
};

}  // namespace tetralux
