// PNG files of every kind, written sample by sample.
#pragma once

#include <gtest/gtest.h>
#include <png.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <vector>

namespace tetralux::test {

struct PngSamples {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  int bits = 8;
  int type = PNG_COLOR_TYPE_RGB;
  std::vector<unsigned> samples{};
  std::vector<png_color> palette{};
  std::vector<png_byte> paletteAlpha{};
  std::optional<png_uint_16> transparentGray{};
  bool interlaced = false;
  double gamma = 0.0;  // gAMA chunk if not 0
};

// Errors end the test program: libpng's own handler aborts where none is set.
inline void writePngSamples(const std::filesystem::path& path, const PngSamples& image) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  ASSERT_NE(file, nullptr);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_set_IHDR(png, info, image.width, image.height, image.bits, image.type,
               image.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (!image.palette.empty()) png_set_PLTE(png, info, image.palette.data(), static_cast<int>(image.palette.size()));
  if (!image.paletteAlpha.empty())
    png_set_tRNS(png, info, image.paletteAlpha.data(), static_cast<int>(image.paletteAlpha.size()), nullptr);
  if (image.transparentGray) {
    png_color_16 colour{};
    colour.gray = *image.transparentGray;
    png_set_tRNS(png, info, nullptr, 0, &colour);
  }
  if (image.gamma != 0.0) png_set_gAMA(png, info, image.gamma);
  png_write_info(png, info);
  png_set_packing(png);  // samples of less than 8 bits are given a byte each
  const size_t rowSamples = image.samples.size() / image.height;
  std::vector<std::vector<png_byte>> rows(image.height);
  for (size_t i = 0; i < image.samples.size(); i++) {
    if (image.bits == 16) rows[i / rowSamples].push_back(static_cast<png_byte>(image.samples[i] >> 8));
    rows[i / rowSamples].push_back(static_cast<png_byte>(image.samples[i] & 0xff));
  }
  std::vector<png_bytep> pointers;
  for (auto& row : rows) pointers.push_back(row.data());
  png_write_image(png, pointers.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  std::fclose(file);
}

// The samples of an 8-bit RGB file as they stand there.
inline std::vector<int> pngLevels(const std::filesystem::path& path) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_file(&header, path.c_str()), 0);
  EXPECT_EQ(header.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
  std::vector<png_byte> samples(PNG_IMAGE_SIZE(header));
  EXPECT_NE(png_image_finish_read(&header, nullptr, samples.data(), 0, nullptr), 0);
  return {samples.begin(), samples.end()};
}

}  // namespace tetralux::test
