#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/check.h"
#include "base/error.h"
#include "base/files.h"
#include "base/parallel.h"
#include "image/color.h"
#include "image/image_io.h"

namespace tetralux {
namespace {

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

// Replaces RGB samples by indices into a palette, in the order of first use. Returns false, and changes nothing, where
// 256 colours are not enough.
bool toPalette(std::vector<png_byte>& samples, std::vector<png_byte>& palette) {
  std::map<std::array<png_byte, 3>, png_byte> indices;
  std::vector<png_byte> indexed;
  for (size_t i = 0; i < samples.size(); i += 3) {
    const std::array<png_byte, 3> color = {samples[i], samples[i + 1], samples[i + 2]};
    const auto [entry, isNew] = indices.try_emplace(color, static_cast<png_byte>(indices.size()));
    if (indices.size() > 256) return false;
    if (isNew) palette.insert(palette.end(), color.begin(), color.end());
    indexed.push_back(entry->second);
  }
  samples = std::move(indexed);
  return true;
}

}  // namespace

std::vector<std::byte> encodePng(const Image& image, const glm::vec3& background, PngColors colors) {
  CHECK_LT(0u, image.width);
  CHECK_LT(0u, image.height);
  CHECK_EQ(image.pixels.size(), static_cast<size_t>(image.width) * image.height);
  // libpng's simplified interface catches its own errors; for an 8-bit format it writes the sRGB chunk.
  std::vector<png_byte> samples = encodeOver(image, background);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = image.width;
  header.height = image.height;
  header.format = PNG_FORMAT_RGB;
  std::vector<png_byte> palette;
  if (colors == PngColors::Palette && toPalette(samples, palette)) {
    header.format = PNG_FORMAT_RGB_COLORMAP;
    header.colormap_entries = static_cast<png_uint_32>(palette.size() / 3);
  }
  // An upper bound, so that the image is compressed once; asking for the size would compress it.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::vector<std::byte> bytes(size);
  if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, samples.data(), 0, palette.data()))
    fail(ErrorCode::Output, "PNG image of {} x {} pixels: {}", image.width, image.height, header.message);
  bytes.resize(size);
  return bytes;
}

void writePng(const Image& image, const std::filesystem::path& path, const glm::vec3& background) {
  const std::vector<std::byte> bytes = encodePng(image, background);
  writeFile(path, bytes.data(), bytes.size());
}

}  // namespace tetralux
