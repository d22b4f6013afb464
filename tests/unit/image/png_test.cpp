// PNG files that are written and read back, and files of all kinds.
#include <gtest/gtest.h>
#include <png.h>

#include <limits>

#include "base/files.h"
#include "image/color.h"
#include "image/image_io.h"
#include "image_fixtures.h"
#include "png_samples.h"
#include "support/temp_dir.h"

namespace tetralux {
namespace {

using namespace test;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// The levels, 0..255, that writePng gives one pixel.
std::vector<int> levelsOf(const glm::vec4& pixel, const glm::vec3& background) {
  const TempDir dir;
  writePng(constantImage(1, 1, pixel), dir / "a.png", background);
  return pngLevels(dir / "a.png");
}

// --- Writing ---------------------------------------------------------------------------------------------------------

TEST(WritePng, KnownLinearValuesGetTheirSrgbLevels) {
  // 0.5 -> 187.5158; 0.2140411 -> 127.5000; 0.001 -> 3.2946; 0.18 -> 117.6496
  EXPECT_EQ(levelsOf({0.5f, 0.001f, 0.18f, 1.0f}, glm::vec3(0.0f)), (std::vector<int>{188, 3, 118}));
  EXPECT_EQ(levelsOf({0.0f, 1.0f, 0.2139f, 1.0f}, glm::vec3(0.0f)), (std::vector<int>{0, 255, 127}));
  EXPECT_EQ(levelsOf({0.2142f, 1e-9f, 0.9999f, 1.0f}, glm::vec3(0.0f)), (std::vector<int>{128, 0, 255}));
}

TEST(WritePng, BackgroundShowsWhereTheImageIsTransparent) {
  // Half covered red over linear (0, 0.5, 1): premultiplied (0.5, 0, 0) + half of the background.
  EXPECT_EQ(levelsOf({0.5f, 0.0f, 0.0f, 0.5f}, {0.0f, 0.5f, 1.0f}), (std::vector<int>{188, 137, 188}));
  EXPECT_EQ(levelsOf({0.0f, 0.0f, 0.0f, 0.0f}, {1.0f, 0.5f, 0.0f}), (std::vector<int>{255, 188, 0}));
  EXPECT_EQ(levelsOf({0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f}), (std::vector<int>{0, 0, 0}));
}

TEST(WritePng, ValuesBeyondTheScaleAreClamped) {
  EXPECT_EQ(levelsOf({-3.0f, 7.0f, 1e30f, 1.0f}, glm::vec3(0.0f)), (std::vector<int>{0, 255, 255}));
  EXPECT_EQ(levelsOf({-kInfinity, kInfinity, 0.0f, 1.0f}, glm::vec3(0.0f)), (std::vector<int>{0, 255, 0}));
}

TEST(WritePng, NanIsBlack) {
  EXPECT_EQ(levelsOf({kNan, 1.0f, 0.0f, 1.0f}, glm::vec3(1.0f)), (std::vector<int>{0, 255, 0}));
  EXPECT_EQ(levelsOf({1.0f, 1.0f, 1.0f, kNan}, glm::vec3(1.0f)), (std::vector<int>{0, 0, 0}));
}

TEST(EncodePng, APaletteChangesNoColour) {
  const TempDir dir;
  const auto decoded = [&](const Image& image, PngColors colors) {
    const auto bytes = encodePng(image, glm::vec3(0.2f), colors);
    writeFile(dir / "a.png", bytes.data(), bytes.size());
    return readPng(dir / "a.png").pixels;
  };
  Image few = smoothImage(64, 48);
  for (glm::vec4& pixel : few.pixels) pixel = glm::round(pixel * 4.0f) / 4.0f;
  EXPECT_EQ(decoded(few, PngColors::Palette), decoded(few, PngColors::Rgb));
  constexpr size_t kColorType = 25;  // in the file: IHDR's fourth number
  EXPECT_EQ(std::to_integer<int>(encodePng(few, glm::vec3(0.2f), PngColors::Palette)[kColorType]),
            PNG_COLOR_TYPE_PALETTE);
  EXPECT_EQ(std::to_integer<int>(encodePng(few, glm::vec3(0.2f))[kColorType]), PNG_COLOR_TYPE_RGB);
  const Image many = smoothImage(64, 48);
  EXPECT_EQ(encodePng(many, glm::vec3(0.2f), PngColors::Palette), encodePng(many, glm::vec3(0.2f)));
}

TEST(WritePng, FileSaysThatItIsSrgb) {
  const TempDir dir;
  writePng(smoothImage(3, 2), dir / "a.png", glm::vec3(0.0f));
  const std::string content = readTextFile(dir / "a.png");
  EXPECT_NE(content.find("sRGB"), std::string::npos);
  EXPECT_EQ(content[24], 8);  // IHDR: bits per sample
  EXPECT_EQ(content[25], 2);  // RGB without alpha
  EXPECT_EQ(dir.entries(), 1u);
}

TEST(WritePng, EveryLevelRoundTrips) {
  const TempDir dir;
  Image image(256, 3);
  for (std::uint32_t x = 0; x < 256; x++) {
    for (std::uint32_t y = 0; y < 3; y++) {
      const auto value = static_cast<float>(linearFromSrgb(x / 255.0));
      image.at(x, y) = {y == 0 ? value : 0.0f, y == 1 ? value : 0.25f, y == 2 ? value : 1.0f, 1.0f};
    }
  }
  writePng(image, dir / "a.png", glm::vec3(0.5f));
  const Image once = readPng(dir / "a.png");
  EXPECT_LT(largestDifference(once, image), 0.004);  // 0.25 is between two levels
  writePng(once, dir / "b.png", glm::vec3(0.5f));
  EXPECT_EQ(pngLevels(dir / "a.png"), pngLevels(dir / "b.png"));
  for (std::uint32_t x = 0; x < 256; x++) EXPECT_EQ(once.at(x, 0).r, image.at(x, 0).r) << x;
}

TEST(WritePng, RowZeroIsTheTopRow) {
  const TempDir dir;
  Image image = constantImage(1, 2, {0.0f, 0.0f, 0.0f, 1.0f});
  image.at(0, 0) = {1.0f, 1.0f, 1.0f, 1.0f};
  writePng(image, dir / "a.png", glm::vec3(0.0f));
  EXPECT_EQ(pngLevels(dir / "a.png"), (std::vector<int>{255, 255, 255, 0, 0, 0}));
  EXPECT_EQ(readPng(dir / "a.png").at(0, 0).r, 1.0f);
}

// --- Reading ---------------------------------------------------------------------------------------------------------

float linear(double encoded) { return static_cast<float>(linearFromSrgb(encoded)); }

TEST(ReadPng, AlphaIsPremultiplied) {
  const TempDir dir;
  writePngSamples(dir / "a.png", {.width = 1, .type = PNG_COLOR_TYPE_RGBA, .samples = {255, 128, 0, 51}});
  const Image image = readPng(dir / "a.png");
  EXPECT_FLOAT_EQ(image.at(0, 0).r, 0.2f);
  EXPECT_FLOAT_EQ(image.at(0, 0).g, 0.2f * linear(128.0 / 255.0));
  EXPECT_EQ(image.at(0, 0).b, 0.0f);
  EXPECT_FLOAT_EQ(image.at(0, 0).a, 0.2f);
}

TEST(ReadPng, SixteenBitsAreAllUsed) {
  const TempDir dir;
  writePngSamples(dir / "a.png",
                  {.width = 2, .bits = 16, .type = PNG_COLOR_TYPE_RGB, .samples = {0, 1, 256, 65535, 32768, 32769}});
  const Image image = readPng(dir / "a.png");
  EXPECT_EQ(image.at(0, 0), glm::vec4(0.0f, linear(1 / 65535.0), linear(256 / 65535.0), 1.0f));
  EXPECT_EQ(image.at(1, 0), glm::vec4(1.0f, linear(32768 / 65535.0), linear(32769 / 65535.0), 1.0f));
}

TEST(ReadPng, GrayIsAllThreeColours) {
  const TempDir dir;
  for (const int bits : {1, 2, 4, 8, 16}) {
    const unsigned top = (1u << bits) - 1;
    writePngSamples(dir / "a.png", {.width = 2, .bits = bits, .type = PNG_COLOR_TYPE_GRAY, .samples = {1, top}});
    const Image image = readPng(dir / "a.png");
    const float expected = linear(1.0 / top);
    EXPECT_EQ(image.at(0, 0), glm::vec4(expected, expected, expected, 1.0f)) << bits;
    EXPECT_EQ(image.at(1, 0), glm::vec4(1.0f)) << bits;
  }
}

TEST(ReadPng, GrayWithAlphaOf16Bits) {
  const TempDir dir;
  writePngSamples(dir / "a.png",
                  {.width = 1, .bits = 16, .type = PNG_COLOR_TYPE_GRAY_ALPHA, .samples = {65535, 13107}});
  EXPECT_EQ(readPng(dir / "a.png").at(0, 0), glm::vec4(0.2f));
}

TEST(ReadPng, PaletteWithTransparentEntries) {
  const TempDir dir;
  writePngSamples(dir / "a.png", {.width = 3,
                                  .type = PNG_COLOR_TYPE_PALETTE,
                                  .samples = {2, 0, 1},
                                  .palette = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}},
                                  .paletteAlpha = {255, 51}});
  const Image image = readPng(dir / "a.png");
  EXPECT_EQ(image.at(0, 0), glm::vec4(0, 0, 1, 1));
  EXPECT_EQ(image.at(1, 0), glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(image.at(2, 0), glm::vec4(0, 0.2f, 0, 0.2f));
}

TEST(ReadPng, ColourMarkedTransparentIsTransparent) {
  const TempDir dir;
  writePngSamples(dir / "a.png", {.width = 2, .type = PNG_COLOR_TYPE_GRAY, .samples = {255, 7}, .transparentGray = 7});
  EXPECT_EQ(readPng(dir / "a.png").at(0, 0), glm::vec4(1.0f));
  EXPECT_EQ(readPng(dir / "a.png").at(1, 0), glm::vec4(0.0f));
}

TEST(ReadPng, InterlacedFilesAreReadInOrder) {
  const TempDir dir;
  PngSamples samples{.width = 9, .height = 7, .type = PNG_COLOR_TYPE_RGB, .interlaced = true};
  for (unsigned i = 0; i < 9 * 7 * 3; i++) samples.samples.push_back(i % 256);
  writePngSamples(dir / "a.png", samples);
  const Image image = readPng(dir / "a.png");
  for (unsigned i = 0; i < 9 * 7 * 3; i++)
    EXPECT_EQ(image.pixels[i / 3][static_cast<int>(i % 3)], linear((i % 256) / 255.0));
}

TEST(ReadPng, GammaOfTheFileCountsUnlessItMeansSrgb) {
  const TempDir dir;
  const PngSamples gray{.width = 1, .type = PNG_COLOR_TYPE_GRAY, .samples = {51}};
  PngSamples linearGray = gray;
  linearGray.gamma = 1.0;
  writePngSamples(dir / "linear.png", linearGray);
  EXPECT_FLOAT_EQ(readPng(dir / "linear.png").at(0, 0).r, 0.2f);
  PngSamples usual = gray;
  usual.gamma = 1.0 / 2.2;
  writePngSamples(dir / "usual.png", usual);
  EXPECT_EQ(readPng(dir / "usual.png").at(0, 0).r, linear(0.2));
}

}  // namespace
}  // namespace tetralux
