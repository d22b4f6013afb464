#include "image/metrics.h"

#include <gtest/gtest.h>

#include <limits>

#include "image_fixtures.h"

namespace tetralux {
namespace {

using namespace test;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(CompareImages, EqualImagesHaveNoDifference) {
  const ImageDifference d = compareImages(smoothImage(13, 7), smoothImage(13, 7));
  EXPECT_EQ(d.rmse, 0.0);
  EXPECT_EQ(d.max, 0.0);
  EXPECT_EQ(d.p99, 0.0);
  EXPECT_EQ(d.mean, 0.0);
  EXPECT_EQ(d.shareOverHalfLevel, 0.0);
  EXPECT_EQ(d.psnr, std::numeric_limits<double>::infinity());
  EXPECT_EQ(d.flip, 0.0);
  EXPECT_EQ(d.nonFinite, 0u);
}

TEST(CompareImages, OneValueOffHasTheClosedForms) {
  const Image reference(4, 2);  // 32 values
  Image test = reference;
  test.at(2, 1).g = -0.5f;
  const ImageDifference d = compareImages(reference, test);
  EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(0.25 / 32.0));
  EXPECT_DOUBLE_EQ(d.max, 0.5);
  EXPECT_DOUBLE_EQ(d.mean, 0.5 / 32.0);
  EXPECT_DOUBLE_EQ(d.p99, 0.5);  // of fewer than 100 values it is the largest
  EXPECT_DOUBLE_EQ(d.shareOverHalfLevel, 1.0 / 8.0);
  EXPECT_NEAR(d.psnr, 10.0 * std::log10(32.0 / 0.25), 1e-12);
  EXPECT_EQ(d.worstX, 2u);
  EXPECT_EQ(d.worstY, 1u);
}

TEST(CompareImages, ConstantOffsetIsEveryFigure) {
  const ImageDifference d =
      compareImages(constantImage(30, 20, glm::vec4(0.25f)), constantImage(30, 20, glm::vec4(0.375f)));
  EXPECT_DOUBLE_EQ(d.rmse, 0.125);
  EXPECT_DOUBLE_EQ(d.max, 0.125);
  EXPECT_DOUBLE_EQ(d.mean, 0.125);
  EXPECT_DOUBLE_EQ(d.p99, 0.125);
  EXPECT_DOUBLE_EQ(d.shareOverHalfLevel, 1.0);
}

// Values off by 1/1024, 2/1024, ... n/1024 in a scrambled order.
ImageDifference rampDifference(std::uint32_t pixels) {
  const Image reference(pixels, 1);
  Image test = reference;
  const size_t n = static_cast<size_t>(pixels) * 4;
  for (size_t i = 0; i < n; i++) {
    const size_t scrambled = i * 7919 % n;  // a prime that divides no n used here
    test.pixels[i / 4][static_cast<int>(i % 4)] = static_cast<float>(scrambled + 1) / 1024.0f;
  }
  return compareImages(reference, test);
}

TEST(CompareImages, PercentileIsTheNearestRank) {
  EXPECT_DOUBLE_EQ(rampDifference(24).p99 * 1024.0, 96.0);    // ceil(0.99 * 96) = 96
  EXPECT_DOUBLE_EQ(rampDifference(25).p99 * 1024.0, 99.0);    // ceil(0.99 * 100) = 99
  EXPECT_DOUBLE_EQ(rampDifference(26).p99 * 1024.0, 103.0);   // ceil(0.99 * 104) = 103
  EXPECT_DOUBLE_EQ(rampDifference(250).p99 * 1024.0, 990.0);  // ceil(0.99 * 1000) = 990
  EXPECT_DOUBLE_EQ(rampDifference(251).p99 * 1024.0, 994.0);  // ceil(0.99 * 1004) = ceil(993.96)
}

TEST(CompareImages, HalfALevelExactlyIsNotOver) {
  Image reference(2, 1);
  Image test(2, 1);
  const auto limit = static_cast<float>(0.5 / 255.0);
  test.at(0, 0).r = static_cast<double>(limit) > 0.5 / 255.0 ? std::nextafter(limit, 0.0f) : limit;
  EXPECT_EQ(compareImages(reference, test).shareOverHalfLevel, 0.0);
  test.at(0, 0).r = std::nextafter(test.at(0, 0).r, 1.0f);
  EXPECT_EQ(compareImages(reference, test).shareOverHalfLevel, 0.5);
}

TEST(CompareImages, SmallDifferencesOfLargeValuesAreKept) {
  const Image reference = constantImage(1, 1, glm::vec4(16777216.0f));
  const Image test = constantImage(1, 1, glm::vec4(16777218.0f));
  EXPECT_EQ(compareImages(reference, test).mean, 2.0);
}

TEST(CompareImages, NonFiniteInOneImageCountsAsOne) {
  Image reference(2, 1);
  Image test(2, 1);
  test.at(1, 0) = {kNan, kInfinity, 0.0f, 0.0f};
  const ImageDifference d = compareImages(reference, test);
  EXPECT_EQ(d.nonFinite, 2u);
  EXPECT_EQ(d.max, 1.0);
  EXPECT_EQ(d.mean, 2.0 / 8.0);
  EXPECT_EQ(d.worstX, 1u);
  EXPECT_EQ(d.shareOverHalfLevel, 0.5);
  EXPECT_TRUE(std::isfinite(d.flip));
  EXPECT_EQ(compareImages(test, reference).mean, d.mean);
}

TEST(CompareImages, SameNonFiniteValueIsNoDifference) {
  Image reference(2, 1);
  reference.at(0, 0) = {kNan, kInfinity, -kInfinity, 0.0f};
  EXPECT_EQ(compareImages(reference, reference).nonFinite, 0u);
  EXPECT_EQ(compareImages(reference, reference).max, 0.0);
  Image test = reference;
  test.at(0, 0) = {kInfinity, -kInfinity, kNan, 0.0f};
  EXPECT_EQ(compareImages(reference, test).nonFinite, 3u);
}

TEST(CompareImages, WorstPixelIsTheFirstOfEqualOnes) {
  const Image reference(3, 3);
  Image test = reference;
  test.at(2, 0).a = 0.25f;
  test.at(0, 1).r = 0.5f;
  test.at(2, 2).b = -0.5f;
  const ImageDifference d = compareImages(reference, test);
  EXPECT_EQ(d.worstX, 0u);
  EXPECT_EQ(d.worstY, 1u);
}

TEST(CompareImages, DifferentSizesAreAnInputErrorWithBoth) {
  EXPECT_EQ(errorOf(ErrorCode::Input, [] { compareImages(Image(4, 3), Image(3, 4)); }),
            "images of different size: 3 x 4 pixels, expected 4 x 3 like the reference");
  EXPECT_EQ(errorOf(ErrorCode::Input, [] { flipError(Image(4, 3), Image(4, 2)); }),
            "images of different size: 4 x 2 pixels, expected 4 x 3 like the reference");
}

}  // namespace
}  // namespace tetralux
