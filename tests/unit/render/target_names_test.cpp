#include <gtest/gtest.h>

#include <cstring>

#include "render/rounding_probe.h"
#include "render/target.h"
#include "shared/limits.h"
#include "support/expect_error.h"

namespace tetralux::render {
namespace {

TEST(Target, NamesAreReadAndWritten) {
  for (const std::string& name : targetNames()) EXPECT_EQ(targetName(parseTarget(name)), name);
  EXPECT_EQ(parseTarget("rgba16f-chunked"), Target::Rgba16fChunked);
  EXPECT_EQ(parseTarget("auto"), Target::Auto);
  EXPECT_EQ(test::errorOf(ErrorCode::Usage, [] { parseTarget("rgba64f"); }),
            "--target: found 'rgba64f', expected one of rgba32f, rgba16f, rgba16f-chunked, rgba8, rgba8-dither, auto");
}

TEST(Target, PixelsOfEveryFormatAreUnpacked) {
  const auto unpack = [](VkFormat format, const auto& packed) {
    EXPECT_EQ(bytesPerPixel(format), sizeof packed);
    std::byte bytes[sizeof packed];
    std::memcpy(bytes, &packed, sizeof packed);
    return unpackPixel(format, bytes);
  };
  const glm::vec4 expected(1.0f, 0.0f, 0.2f, 0.6f);
  EXPECT_EQ(unpack(pictureFormat(Target::Rgba32f), expected), expected);
  EXPECT_EQ(unpack(pictureFormat(Target::Rgba16fChunked), expected), expected);
  EXPECT_EQ(unpack(pictureFormat(Target::Rgba16f), std::uint64_t{0x3800340000003c00}), glm::vec4(1, 0, 0.25f, 0.5f));
  for (const Target target : {Target::Rgba8, Target::Rgba8Dither}) {
    const glm::vec4 pixel = unpack(pictureFormat(target), std::uint32_t{0x993300ff});
    for (int c = 0; c < 4; c++) EXPECT_FLOAT_EQ(pixel[c], expected[c]);
  }
}

TEST(Target, ChunksAreNeitherTooManyNorTooLarge) {
  EXPECT_EQ(chunkCellCount(0, 1), 64u);
  EXPECT_EQ(chunkCellCount(0, 320000), 10001u);
  EXPECT_EQ(chunkCellCount(5, 100), 5u);
  for (const std::uint32_t wanted : {0u, 1u, 1000u, 0xffffffffu}) {
    for (const std::uint32_t cells : {1u, 1000u, 187395u, 20000000u}) {
      const std::uint32_t chunk = chunkCellCount(wanted, cells);
      EXPECT_GE(chunk, 1u);
      EXPECT_LE(chunk, shared::BATCH_CELLS);
      EXPECT_LE((cells + chunk - 1) / chunk, 256u) << wanted << " " << cells;
    }
  }
}

// NUMERICS section 5: 20 layers, or any number of opacity 1/40, where blending rounds to nearest.
TEST(Target, HalfFloatsHoldForFewOrDenseLayers) {
  const auto roundings = [](int layers, double alpha, bool isSquared) {
    double sum = 0.0;
    for (int i = 0; i < layers; i++) sum += std::pow(1.0 - alpha, (isSquared ? 2.0 : 1.0) * i);
    return sum;
  };
  EXPECT_TRUE(halfFloatHolds(roundings(20, 0.001, true), true));
  EXPECT_FALSE(halfFloatHolds(roundings(25, 0.001, true), true));
  EXPECT_TRUE(halfFloatHolds(roundings(5000, 0.025, true), true));
  EXPECT_FALSE(halfFloatHolds(roundings(5000, 0.02, true), true));
  EXPECT_TRUE(halfFloatHolds(roundings(3, 0.001, false), false));
  EXPECT_FALSE(halfFloatHolds(roundings(5, 0.001, false), false));
  EXPECT_TRUE(halfFloatHolds(0.0, true));
}

}  // namespace
}  // namespace tetralux::render
