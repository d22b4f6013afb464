#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/check.h"
#include "base/error.h"
#include "base/files.h"
#include "base/parallel.h"
#include "image/color.h"
#include "image/image_io.h"

namespace tetralux {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

png_byte encode(double linear) {
  if (!(linear > 0.0)) return 0;  // not-a-number, too
  return static_cast<png_byte>(255.0 * srgbFromLinear(std::min(linear, 1.0)) + 0.5);
}

std::vector<png_byte> encodeOver(const Image& image, const glm::dvec3& background) {
  std::vector<png_byte> samples(image.pixels.size() * 3);
  parallelFor(image.pixels.size(), 1 << 14, [&](size_t begin, size_t end, unsigned) {
    for (size_t i = begin; i < end; i++) {
      const glm::dvec4 pixel(image.pixels[i]);
      for (int c = 0; c < 3; c++)
        samples[3 * i + static_cast<size_t>(c)] = encode(pixel[c] + (1.0 - pixel.a) * background[c]);
    }
  });
  return samples;
}

}  // namespace

void writePng(const Image& image, const std::filesystem::path& path, const glm::vec3& background) {
  CHECK_LT(0u, image.width);
  CHECK_LT(0u, image.height);
  CHECK_EQ(image.pixels.size(), static_cast<size_t>(image.width) * image.height);
  PendingFile pending(path);
  const auto failWith = [&](const char* text) {
    fail(ErrorCode::Output, "{}: cannot be written: {}", path.string(), text);
  };
  std::unique_ptr<std::FILE, CloseFile> file(std::fopen(pending.temporaryPath().c_str(), "wb"));
  if (!file) failWith(std::strerror(errno));

  // libpng's simplified interface catches its own errors; for an 8-bit format it writes the sRGB chunk.
  const std::vector<png_byte> samples = encodeOver(image, background);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = image.width;
  header.height = image.height;
  header.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_stdio(&header, file.get(), 0, samples.data(), 0, nullptr))
    failWith(std::ferror(file.get()) ? std::strerror(errno) : header.message);
  if (std::fclose(file.release()) != 0) failWith(std::strerror(errno));
  pending.commit();
}

}  // namespace tetralux
