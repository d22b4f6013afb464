#include "reference/picture_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "image/metrics.h"
#include "mesh/generate.h"
#include "reference/coverage.h"
#include "reference/pixel_sample.h"
#include "reference/share_bound.h"

namespace tetralux::reference {
namespace {

constexpr ImageSize kSize{40, 30};

struct Fixture {
  TetMesh mesh = jitteredGrid(4, 4, 4, glm::dvec3(0.0), glm::dvec3(1.0), 0.1, 1, waveField);
  ScalarField field = scalarField(mesh, "", "test");
  TransferFunction transfer{{{0.0, {0.2, 0.4, 0.8}, 0.5}, {1.0, {0.9, 0.3, 0.1}, 3.0}}, "test"};
  Camera camera;

  Fixture() {
    camera.eye = {2.5, -2.0, 1.7};
    camera.center = {0.5, 0.5, 0.5};
    camera.fovyDegrees = 40.0;
  }
  ReferenceScene scene() const { return {mesh, field, transfer, camera, kSize}; }
  Image exact() const { return toImage(renderPixels(scene()), kSize); }
};

// The exact picture with an error of its own at every pixel.
Image disturbed(Image image) {
  for (size_t i = 0; i < image.pixels.size(); i++) {
    if (image.pixels[i].w > 0.0f) image.pixels[i].y += 1e-4f * static_cast<float>(i % 97);
  }
  return image;
}

TEST(ShareBound, OfNoneFoundIsTheClosedForm) {
  for (const std::uint64_t n : {1u, 10u, 2000u, 1000000u})
    EXPECT_NEAR(upperShareBound(0, n, 0.99), 1.0 - std::pow(0.01, 1.0 / static_cast<double>(n)), 2e-12) << n;
}

TEST(ShareBound, OfAllButOneFoundIsTheClosedForm) {
  // P(X <= n - 1) = 1 - p^n = 0.01
  for (const std::uint64_t n : {2u, 10u, 2000u})
    EXPECT_NEAR(upperShareBound(n - 1, n, 0.99), std::pow(0.99, 1.0 / static_cast<double>(n)), 2e-12) << n;
  EXPECT_EQ(upperShareBound(7, 7, 0.99), 1.0);
}

TEST(ShareBound, IsWhereTheBinomialSumIsOnePercent) {
  // P(X <= 1) = (1 - p)^n + n p (1 - p)^(n - 1)
  const double p = upperShareBound(1, 50, 0.99);
  EXPECT_NEAR(std::pow(1.0 - p, 50) + 50.0 * p * std::pow(1.0 - p, 49), 0.01, 1e-10);
  // A half found of many: the normal approximation, 2.326 standard deviations.
  EXPECT_NEAR(upperShareBound(500000, 1000000, 0.99), 0.5 + 2.3263 * 0.0005, 2e-6);
}

TEST(PixelSample, TakesEveryWantedPixelWhenThereAreFew) {
  std::vector<std::uint8_t> wanted(kSize.width * kSize.height, 0);
  for (const size_t i : {0u, 41u, 900u, 1199u}) wanted[i] = 1;
  const auto positions = stratifiedPixels(kSize, wanted, 10, 1);
  std::set<size_t> found;
  for (const PixelPosition& p : positions) found.insert(size_t{p.y} * kSize.width + p.x);
  EXPECT_EQ(found, (std::set<size_t>{0, 41, 900, 1199}));
  EXPECT_EQ(positions.size(), 4u);
}

// Over many seeds every wanted pixel comes as often as any other, though strata are no whole number of pixels long.
TEST(PixelSample, IsUniform) {
  std::vector<std::uint8_t> wanted(kSize.width * kSize.height, 1);
  for (size_t i = 0; i < wanted.size(); i += 3) wanted[i] = 0;
  std::vector<int> counts(wanted.size(), 0);
  constexpr int kSeeds = 2000;
  for (std::uint32_t seed = 1; seed <= kSeeds; seed++) {
    const auto positions = stratifiedPixels(kSize, wanted, 500, seed);
    EXPECT_EQ(positions.size(), 500u);
    for (const PixelPosition& p : positions) counts[size_t{p.y} * kSize.width + p.x]++;
  }
  const double expected = kSeeds * 500.0 / 800.0;
  for (size_t i = 0; i < wanted.size(); i++) EXPECT_NEAR(counts[i], wanted[i] ? expected : 0.0, 0.12 * expected) << i;
}

TEST(Coverage, IsWhereTheExactPictureIsNotEmpty) {
  const Fixture f;
  const Image exact = f.exact();
  for (const Image& picture : {exact, Image(kSize.width, kSize.height)}) {
    const auto covered = coveredPixels(f.scene(), picture);
    for (size_t i = 0; i < covered.size(); i++) EXPECT_EQ(covered[i] != 0, exact.pixels[i].w > 0.0f) << i;
  }
}

TEST(Coverage, HoldsWhatThePictureShowsByMistake) {
  const Fixture f;
  Image picture = f.exact();
  ASSERT_EQ(picture.pixels[0].w, 0.0f);
  picture.pixels[0].x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(coveredPixels(f.scene(), picture)[0], 1);
}

TEST(Coverage, HoldsNoTransparentCell) {
  Fixture f;
  f.transfer = TransferFunction({{0.0, {1, 1, 1}, 0.0}, {2.0, {1, 1, 1}, 0.0}, {3.0, {1, 1, 1}, 1.0}}, "test");
  const auto covered = coveredPixels(f.scene(), Image(kSize.width, kSize.height));
  EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), 0);
}

// Every covered pixel certified: the figures of a comparison of whole pictures, restricted to those pixels.
TEST(Certificate, OfAllPixelsAgreesWithAFullComparison) {
  const Fixture f;
  const Image exact = f.exact();
  const Image picture = disturbed(exact);
  Image exactCovered(0, 1);
  Image foundCovered(0, 1);
  std::uint64_t over = 0;
  for (size_t i = 0; i < exact.pixels.size(); i++) {
    if (exact.pixels[i].w == 0.0f) continue;
    exactCovered.pixels.push_back(exact.pixels[i]);
    foundCovered.pixels.push_back(picture.pixels[i]);
    over += picture.pixels[i].y - exact.pixels[i].y > 5e-3f ? 1 : 0;
  }
  exactCovered.width = foundCovered.width = static_cast<std::uint32_t>(exactCovered.pixels.size());
  const ImageDifference expected = compareImages(exactCovered, foundCovered);

  const Certificate c = certifyPicture(f.scene(), picture, 100000, 1, 5e-3);
  EXPECT_EQ(c.check.pixels, exactCovered.pixels.size());
  EXPECT_EQ(c.coveredPixels, exactCovered.pixels.size());
  EXPECT_EQ(c.check.max, expected.max);
  EXPECT_EQ(c.check.max, compareImages(exact, picture).max);
  EXPECT_EQ(c.check.p99, expected.p99);
  EXPECT_NEAR(c.check.rmse, expected.rmse, 1e-12);
  EXPECT_GT(over, 0u);
  EXPECT_EQ(c.check.over, over);
  EXPECT_EQ(c.shareOverBound, static_cast<double>(over) / static_cast<double>(c.coveredPixels));
  EXPECT_FALSE(c.holds());
}

// The bound is one: over many seeds no sample promises less than what is wrong (with 99 % confidence, so 2 of 200).
TEST(Certificate, OfASampleBoundsTheShareThatIsWrong) {
  const Fixture f;
  const Image picture = disturbed(f.exact());
  const Certificate all = certifyPicture(f.scene(), picture, 100000, 1, 5e-3);
  int failures = 0;
  for (std::uint32_t seed = 1; seed <= 200; seed++) {
    const Certificate c = certifyPicture(f.scene(), picture, 60, seed, 5e-3);
    EXPECT_EQ(c.check.pixels, 60u);
    EXPECT_LE(c.check.max, all.check.max);
    failures += c.shareOverBound < all.shareOverBound ? 1 : 0;
  }
  EXPECT_LE(failures, 6);
}

TEST(Certificate, OfAnExactPictureHolds) {
  const Fixture f;
  const Certificate c = certifyPicture(f.scene(), f.exact(), 50, 1, 0.0);
  EXPECT_TRUE(c.holds());
  EXPECT_EQ(c.check.max, 0.0);
  EXPECT_NEAR(c.shareOverBound, 1.0 - std::pow(0.01, 1.0 / 50.0), 1e-9);
}

TEST(Certificate, DoesNotHoldForWhatIsNotANumber) {
  const Fixture f;
  Image picture = f.exact();
  picture.at(20, 15).x = std::numeric_limits<float>::quiet_NaN();
  const Certificate c = certifyPicture(f.scene(), picture, 100000, 1, 10.0);
  EXPECT_FALSE(c.holds());
  EXPECT_EQ(c.check.over, 1u);
}

TEST(Certificate, OfAnEmptyPictureHolds) {
  Fixture f;
  f.camera.eye = {9, 9, 9};
  f.camera.center = {19, 19, 19};
  const Certificate c = certifyPicture(f.scene(), Image(kSize.width, kSize.height), 100, 1, 0.0);
  EXPECT_TRUE(c.holds());
  EXPECT_EQ(c.check.pixels, 0u);
  EXPECT_EQ(c.shareOverBound, 0.0);
}

}  // namespace
}  // namespace tetralux::reference
