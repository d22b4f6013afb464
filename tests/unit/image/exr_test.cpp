// EXR files that are written and read back, and files of other programs' kinds.
#include <gtest/gtest.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "base/files.h"
#include "image/image_io.h"
#include "image_fixtures.h"
#include "support/temp_dir.h"

namespace tetralux {
namespace {

using namespace test;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// --- Round trips -----------------------------------------------------------------------------------------------------

struct RoundTrip {
  ExrCompression compression;
  double floatBound;  // largest error of values up to 1, beyond rounding to the pixel type
  double halfBound;
};

class ExrRoundTrip : public ::testing::TestWithParam<RoundTrip> {};

TEST_P(ExrRoundTrip, FloatStaysWithinTheCompressionsBound) {
  const TempDir dir;
  const Image image = smoothImage(37, 53);  // no multiple of any block size
  writeExr(image, dir / "a.exr", {.compression = GetParam().compression});
  EXPECT_LE(largestDifference(readExr(dir / "a.exr"), image), GetParam().floatBound);
  EXPECT_EQ(dir.entries(), 1u);
}

TEST_P(ExrRoundTrip, HalfStaysWithinTheCompressionsBound) {
  const TempDir dir;
  const Image image = smoothImage(19, 300);  // more than one band of rows
  writeExr(image, dir / "a.exr", {.half = true, .compression = GetParam().compression});
  constexpr double kRounding = 1.0 / 4096.0;  // half of the spacing of half numbers below 1
  EXPECT_LE(largestDifference(readExr(dir / "a.exr"), image), kRounding + GetParam().halfBound);
}

// Pxr24 keeps 15 of the 23 fraction bits; B44 packs blocks of 4 x 4 half values and leaves float alone; Dwa quantises
// cosine coefficients of colours, as half.
INSTANTIATE_TEST_SUITE_P(
    All, ExrRoundTrip,
    ::testing::Values(RoundTrip{ExrCompression::None, 0.0, 0.0}, RoundTrip{ExrCompression::Rle, 0.0, 0.0},
                      RoundTrip{ExrCompression::Zips, 0.0, 0.0}, RoundTrip{ExrCompression::Zip, 0.0, 0.0},
                      RoundTrip{ExrCompression::Piz, 0.0, 0.0}, RoundTrip{ExrCompression::Pxr24, 1.0 / 65536.0, 0.0},
                      RoundTrip{ExrCompression::B44, 0.0, 0.02}, RoundTrip{ExrCompression::B44a, 0.0, 0.02},
                      RoundTrip{ExrCompression::Dwaa, 0.02, 0.02}, RoundTrip{ExrCompression::Dwab, 0.02, 0.02}),
    [](const auto& test) { return exrCompressionName(test.param.compression); });

TEST(WriteExr, CompressionOfTheFileIsTheOneAskedFor) {
  const TempDir dir;
  for (int i = 0; i <= static_cast<int>(ExrCompression::Dwab); i++) {
    writeExr(smoothImage(4, 4), dir / "a.exr", {.compression = static_cast<ExrCompression>(i)});
    EXPECT_EQ(static_cast<int>(Imf::InputFile((dir / "a.exr").c_str()).header().compression()), i);
  }
}

TEST(WriteExr, SinglePixelAndSingleRowsRoundTrip) {
  const TempDir dir;
  for (const auto& [w, h] : {std::pair(1u, 1u), std::pair(301u, 1u), std::pair(1u, 301u)}) {
    for (const bool half : {false, true}) {
      writeExr(constantImage(w, h, {0.5f, 2.0f, -1.0f, 0.25f}), dir / "a.exr", {.half = half});
      EXPECT_EQ(largestDifference(readExr(dir / "a.exr"), constantImage(w, h, {0.5f, 2.0f, -1.0f, 0.25f})), 0.0);
    }
  }
}

TEST(WriteExr, ExtremeFloatsKeepTheirBits) {
  const TempDir dir;
  Image image(2, 1);
  image.at(0, 0) = {std::numeric_limits<float>::max(), std::numeric_limits<float>::denorm_min(), -0.0f, kInfinity};
  image.at(1, 0) = {-kInfinity, std::numeric_limits<float>::quiet_NaN(), 1e-30f, 65520.0f};
  writeExr(image, dir / "a.exr");
  const Image back = readExr(dir / "a.exr");
  EXPECT_EQ(std::memcmp(back.pixels.data(), image.pixels.data(), 2 * sizeof(glm::vec4)), 0);
}

TEST(WriteExr, HalfRoundsToNearestEvenAndStaysFinite) {
  const TempDir dir;
  Image image(3, 1);
  // Half numbers between 1 and 2 are 1/1024 apart: ties go to the even neighbour, others to the nearest.
  image.at(0, 0) = {1.0f + 0.5f / 1024.0f, 1.0f + 1.5f / 1024.0f, 1.0f + 0.51f / 1024.0f, 1.0f + 0.49f / 1024.0f};
  image.at(1, 0) = {65504.0f, 65520.0f, -1e30f, 1.0f};
  image.at(2, 0) = {kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN(), 1e-9f};
  writeExr(image, dir / "a.exr", {.half = true});
  const Image back = readExr(dir / "a.exr");
  EXPECT_EQ(back.at(0, 0), glm::vec4(1.0f, 1.0f + 2.0f / 1024.0f, 1.0f + 1.0f / 1024.0f, 1.0f));
  EXPECT_EQ(back.at(1, 0), glm::vec4(65504.0f, 65504.0f, -65504.0f, 1.0f));
  EXPECT_EQ(back.at(2, 0).r, kInfinity);
  EXPECT_EQ(back.at(2, 0).g, -kInfinity);
  EXPECT_TRUE(std::isnan(back.at(2, 0).b));
  EXPECT_EQ(back.at(2, 0).a, 0.0f);
}

// --- Header ----------------------------------------------------------------------------------------------------------

TEST(WriteExr, WindowsBeginAtZeroAndTypesAreAsAsked) {
  const TempDir dir;
  for (const bool half : {false, true}) {
    writeExr(smoothImage(5, 3), dir / "a.exr", {.half = half});
    const Imf::InputFile file((dir / "a.exr").c_str());
    EXPECT_EQ(file.header().dataWindow(), Imath::Box2i(Imath::V2i(0, 0), Imath::V2i(4, 2)));
    EXPECT_EQ(file.header().displayWindow(), file.header().dataWindow());
    for (const char* name : {"R", "G", "B", "A"})
      EXPECT_EQ(file.header().channels()[name].type, half ? Imf::HALF : Imf::FLOAT);
  }
}

TEST(WriteExr, ExtraChannelIsFloatWhateverTheOthersAre) {
  const TempDir dir;
  const Image image = smoothImage(7, 300);
  std::vector<float> counts(image.pixels.size());
  for (size_t i = 0; i < counts.size(); i++) counts[i] = static_cast<float>(100000 + i);
  for (const bool half : {false, true}) {
    writeExr(image, dir / "a.exr", {.half = half, .extraChannelName = "layers", .extraChannel = counts});
    Imf::InputFile file((dir / "a.exr").c_str());
    EXPECT_EQ(file.header().channels()["layers"].type, Imf::FLOAT);
    std::vector<float> back(counts.size());
    Imf::FrameBuffer frame;
    frame.insert("layers", Imf::Slice::Make(Imf::FLOAT, back.data(), file.header().dataWindow()));
    file.setFrameBuffer(frame);
    file.readPixels(0, 299);
    EXPECT_EQ(back, counts);
    EXPECT_LE(largestDifference(readExr(dir / "a.exr"), image), half ? 1.0 / 4096.0 : 0.0);
  }
}

TEST(WriteExr, WorldToCameraTransformsPointsLikeViewFromWorld) {
  const TempDir dir;
  const glm::dmat4 viewFromWorld =
      glm::translate(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1.0, 2.0, -0.5))), {3.0, -1.0, 2.0});
  writeExr(smoothImage(2, 2), dir / "a.exr", {.viewFromWorld = viewFromWorld});
  const Imf::InputFile file((dir / "a.exr").c_str());
  ASSERT_TRUE(Imf::hasWorldToCamera(file.header()));
  EXPECT_FALSE(Imf::hasWorldToNDC(file.header()));
  const glm::dvec4 expected = viewFromWorld * glm::dvec4(0.3, -0.6, 1.4, 1.0);
  const Imath::V3f view = Imath::V3f(0.3f, -0.6f, 1.4f) * Imf::worldToCamera(file.header());
  for (int c = 0; c < 3; c++) EXPECT_NEAR(static_cast<double>(view[static_cast<unsigned>(c)]), expected[c], 1e-6);
}

TEST(WriteExr, WorldToNdcTakesAPointToItsPlaceInTheImage) {
  const TempDir dir;
  // A perspective of x right, y up, w = depth: 8 x 4 pixels, pixels per unit 10.
  glm::dmat4 clipFromView(0.0);
  clipFromView[0][0] = 2.0 * 10.0 / 8.0;
  clipFromView[1][1] = 2.0 * 10.0 / 4.0;
  clipFromView[2][2] = 1.0;
  clipFromView[2][3] = 1.0;
  const glm::dmat4 viewFromWorld = glm::translate(glm::dmat4(1.0), {0.0, 0.0, 5.0});
  writeExr(smoothImage(8, 4), dir / "a.exr", {.clipFromWorld = clipFromView * viewFromWorld});
  const Imf::InputFile file((dir / "a.exr").c_str());
  ASSERT_TRUE(Imf::hasWorldToNDC(file.header()));
  EXPECT_FALSE(Imf::hasWorldToCamera(file.header()));
  // 3 pixels right of the image's middle and 1 above it, at depth 4.
  const Imath::V3f ndc = Imath::V3f(3.0f / 10.0f * 4.0f, 1.0f / 10.0f * 4.0f, -1.0f) * Imf::worldToNDC(file.header());
  EXPECT_NEAR(static_cast<double>(ndc.x) * 8.0, 7.0, 1e-5);
  EXPECT_NEAR(static_cast<double>(ndc.y) * 4.0, 1.0, 1e-5);  // from the top
}

TEST(WriteExr, StringAttributesAreFoundAgain) {
  const TempDir dir;
  const std::string longName(60, 'n');
  writeExr(smoothImage(2, 2), dir / "a.exr",
           {.viewFromWorld = glm::dmat4(1.0), .attributes = {{"tetralux:device", "none\nat all"}, {longName, ""}}});
  EXPECT_EQ(readExrAttribute(dir / "a.exr", "tetralux:device"), "none\nat all");
  EXPECT_EQ(readExrAttribute(dir / "a.exr", longName), "");
  EXPECT_EQ(readExrAttribute(dir / "a.exr", "tetralux:driver"), std::nullopt);
  EXPECT_EQ(readExrAttribute(dir / "a.exr", "worldToCamera"), std::nullopt);  // there, but no string
}

TEST(WriteExr, SameImageGivesTheSameBytes) {
  const TempDir dir;
  writeExr(smoothImage(200, 200), dir / "a.exr", {.half = true});
  writeExr(smoothImage(200, 200), dir / "b.exr", {.half = true});
  EXPECT_EQ(readFile(dir / "a.exr"), readFile(dir / "b.exr"));
}

// --- Files of other kinds --------------------------------------------------------------------------------------------

// Writes one channel per name, pixel (x, y) holding 10 y + x + 100 times the channel's index.
void writeChannels(const std::filesystem::path& path, const std::vector<std::string>& names, Imf::PixelType type,
                   const Imath::Box2i& window, bool tiled) {
  const size_t width = static_cast<size_t>(window.max.x - window.min.x + 1);
  const size_t height = static_cast<size_t>(window.max.y - window.min.y + 1);
  Imf::Header header(Imath::Box2i(Imath::V2i(0, 0), Imath::V2i(19, 19)), window);
  Imf::FrameBuffer frame;
  std::vector<std::vector<float>> floats(names.size());
  std::vector<std::vector<half>> halfs(names.size());
  std::vector<std::vector<unsigned>> uints(names.size());
  for (size_t n = 0; n < names.size(); n++) {
    for (size_t i = 0; i < width * height; i++) {
      const unsigned value = static_cast<unsigned>(10 * (i / width) + i % width + 100 * n);
      uints[n].push_back(value);
      floats[n].push_back(static_cast<float>(value));
      halfs[n].push_back(half(static_cast<float>(value)));
    }
    const void* first = type == Imf::UINT   ? static_cast<const void*>(uints[n].data())
                        : type == Imf::HALF ? static_cast<const void*>(halfs[n].data())
                                            : static_cast<const void*>(floats[n].data());
    header.channels().insert(names[n], Imf::Channel(type));
    frame.insert(names[n], Imf::Slice::Make(type, first, window));
  }
  if (tiled) {
    header.setTileDescription(Imf::TileDescription(4, 4));
    Imf::TiledOutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  } else {
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(static_cast<int>(height));
  }
}

const Imath::Box2i kOrdinary(Imath::V2i(0, 0), Imath::V2i(6, 4));

class ExrPixelTypes : public ::testing::TestWithParam<std::tuple<Imf::PixelType, bool>> {};

TEST_P(ExrPixelTypes, AreReadFromScanLinesAndTiles) {
  const auto [type, tiled] = GetParam();
  const TempDir dir;
  writeChannels(dir / "a.exr", {"R", "G", "B", "A"}, type, kOrdinary, tiled);
  const Image image = readExr(dir / "a.exr");
  ASSERT_EQ(image.width, 7u);
  ASSERT_EQ(image.height, 5u);
  EXPECT_EQ(image.at(0, 0), glm::vec4(0, 100, 200, 300));
  EXPECT_EQ(image.at(6, 4), glm::vec4(46, 146, 246, 346));
}

INSTANTIATE_TEST_SUITE_P(All, ExrPixelTypes,
                         ::testing::Combine(::testing::Values(Imf::UINT, Imf::HALF, Imf::FLOAT), ::testing::Bool()));

TEST(ReadExr, MissingAlphaIsOpaque) {
  const TempDir dir;
  writeChannels(dir / "a.exr", {"R", "G", "B", "Z"}, Imf::HALF, kOrdinary, false);
  EXPECT_EQ(readExr(dir / "a.exr").at(2, 1), glm::vec4(12, 112, 212, 1));
}

TEST(ReadExr, DataWindowMayLieAnywhere) {
  const TempDir dir;
  for (const bool tiled : {false, true}) {
    writeChannels(dir / "a.exr", {"R", "G", "B"}, Imf::FLOAT, Imath::Box2i(Imath::V2i(-7, 12), Imath::V2i(-2, 21)),
                  tiled);
    const Image image = readExr(dir / "a.exr");
    ASSERT_EQ(image.width, 6u);
    ASSERT_EQ(image.height, 10u);
    EXPECT_EQ(image.at(0, 0), glm::vec4(0, 100, 200, 1));
    EXPECT_EQ(image.at(5, 9), glm::vec4(95, 195, 295, 1));
  }
}

TEST(ReadExr, MissingColourChannelIsNamedWithThoseThatAreThere) {
  const TempDir dir;
  writeChannels(dir / "y.exr", {"Y"}, Imf::HALF, kOrdinary, false);
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExr(dir / "y.exr"); }),
            (dir / "y.exr").string() + ": has no channel R: channels are Y, expected R, G, B and perhaps A");
  writeChannels(dir / "b.exr", {"A", "G", "R"}, Imf::HALF, kOrdinary, false);
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExr(dir / "b.exr"); }),
            (dir / "b.exr").string() + ": has no channel B: channels are A, G, R, expected R, G, B and perhaps A");
}

TEST(ReadExr, FirstOfSeveralPartsIsRead) {
  const TempDir dir;
  std::vector<Imf::Header> headers;
  for (const char* name : {"first", "second"}) {
    Imf::Header header(2, 1);
    header.setName(name);
    header.setType(Imf::SCANLINEIMAGE);
    for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    headers.push_back(header);
  }
  {
    Imf::MultiPartOutputFile file((dir / "a.exr").c_str(), headers.data(), 2);
    for (int part = 0; part < 2; part++) {
      const std::vector<float> values{1.0f + static_cast<float>(part), 3.0f};
      Imf::FrameBuffer frame;
      for (const char* channel : {"R", "G", "B"})
        frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, values.data(), headers[0].dataWindow()));
      Imf::OutputPart output(file, part);
      output.setFrameBuffer(frame);
      output.writePixels(1);
    }
  }
  EXPECT_EQ(readExr(dir / "a.exr").at(0, 0), glm::vec4(1.0f));
  EXPECT_EQ(readExr(dir / "a.exr").at(1, 0), glm::vec4(3, 3, 3, 1));
}

TEST(ReadExr, DeepImageIsRefused) {
  const TempDir dir;
  Imf::Header header(1, 1);
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  {
    unsigned count = 1;
    float value = 0.5f;
    float* samples = &value;
    Imf::DeepFrameBuffer frame;
    frame.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(&count)));
    for (const char* channel : {"R", "G", "B"})
      frame.insert(channel, Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(&samples), 0, 0, sizeof(float)));
    Imf::DeepScanLineOutputFile file((dir / "a.exr").c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(1);
  }
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { readExr(dir / "a.exr"); }),
            (dir / "a.exr").string() + ": is a deep image (deepscanline), expected a flat one");
}

}  // namespace
}  // namespace tetralux
