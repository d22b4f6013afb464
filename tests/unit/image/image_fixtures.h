// Images, files and failures that the tests of src/image share.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <string>

#include "base/error.h"
#include "image/image.h"
#include "image/image_io.h"

namespace tetralux::test {

inline Image constantImage(std::uint32_t width, std::uint32_t height, const glm::vec4& colour) {
  Image image(width, height);
  std::fill(image.pixels.begin(), image.pixels.end(), colour);
  return image;
}

// Smooth colours, all channels and pixels different, 0..1.
inline Image smoothImage(std::uint32_t width, std::uint32_t height) {
  Image image(width, height);
  for (std::uint32_t y = 0; y < height; y++) {
    for (std::uint32_t x = 0; x < width; x++) {
      const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(width);
      const float v = (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
      image.at(x, y) = {0.1f + 0.8f * u, 0.9f - 0.7f * v, 0.5f + 0.4f * std::sin(3.0f * u + 2.0f * v),
                        0.2f + 0.7f * u * v};
    }
  }
  return image;
}

// A fixed sequence of numbers in [0, 1) without pattern (xorshift, Marsaglia 2003).
class Noise {
 public:
  explicit Noise(std::uint32_t seed) : state_(seed) {}
  float next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return static_cast<float>(state_ >> 8) / 16777216.0f;
  }

 private:
  std::uint32_t state_;
};

// The image with every colour moved by up to +-size, alpha kept.
inline Image withNoise(Image image, float size, std::uint32_t seed) {
  Noise noise(seed);
  for (glm::vec4& pixel : image.pixels) {
    for (int c = 0; c < 3; c++) pixel[c] += size * (2.0f * noise.next() - 1.0f);
  }
  return image;
}

inline double largestDifference(const Image& a, const Image& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  double largest = 0.0;
  for (size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); i++) {
    for (int c = 0; c < 4; c++)
      largest = std::max(largest, std::abs(static_cast<double>(a.pixels[i][c]) - static_cast<double>(b.pixels[i][c])));
  }
  return largest;
}

// The text of the Error that the action throws, which must have this code.
template <typename Action>
std::string errorOf(ErrorCode code, const Action& action) {
  try {
    action();
  } catch (const Error& e) {
    EXPECT_EQ(static_cast<int>(e.code()), static_cast<int>(code)) << e.what();
    return e.what();
  }
  return "no error";
}

// While it lives, no file of this process grows beyond `bytes`: a disk that is full. The tests' own output is affected,
// too, so it should live for one call only.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &limit_);
    const rlimit small{bytes, limit_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &limit_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit limit_{};
};

}  // namespace tetralux::test
