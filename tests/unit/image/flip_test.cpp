#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "image/color.h"
#include "image/metrics.h"
#include "image_fixtures.h"

namespace tetralux {
namespace {

using namespace test;

const glm::vec4 kBlack(0.0f, 0.0f, 0.0f, 1.0f);
const glm::vec4 kWhite(1.0f);
const glm::vec4 kGray(0.2f, 0.2f, 0.2f, 1.0f);

// --- Closed forms ----------------------------------------------------------------------------------------------------

TEST(Flip, IdenticalImagesAreZero) {
  const Image image = withNoise(smoothImage(40, 70), 0.3f, 7);
  EXPECT_EQ(flipError(image, image), 0.0);
}

// Constant images have no features, and a filter of sum 1 leaves them alone: what remains is the colour metric, from
// two colours' lightness and chroma alone. Everything is written out here from the standards' printed numbers.
double constantColourError(double hyab) {
  const auto curve = [](double t) { return std::cbrt(t); };
  const double white[3] = {0.9505, 1.0, 1.0890};
  const double green[3] = {0.3576, 0.7152, 0.1192};
  const double blue[3] = {0.1805, 0.0722, 0.9505};
  const auto huntLab = [&](const double(&xyz)[3]) {
    const double x = curve(xyz[0] / white[0]), y = curve(xyz[1] / white[1]), z = curve(xyz[2] / white[2]);
    const double l = 116.0 * y - 16.0;
    return glm::dvec3(l, 0.01 * l * 500.0 * (x - y), 0.01 * l * 200.0 * (y - z));
  };
  const glm::dvec3 d = huntLab(green) - huntLab(blue);
  const double largest = std::pow(std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z), 0.7);
  const double error = std::pow(hyab, 0.7);
  return error < 0.4 * largest ? 0.95 / (0.4 * largest) * error
                               : 0.95 + 0.05 * (error - 0.4 * largest) / (0.6 * largest);
}

TEST(Flip, BlackAgainstWhiteIsTheColourTermOfAHundred) {
  const double expected = constantColourError(100.0);
  EXPECT_NEAR(expected, 0.9674, 1e-3);
  EXPECT_NEAR(flipError(constantImage(33, 50, kBlack), constantImage(33, 50, kWhite)), expected, 1e-5);
}

TEST(Flip, GraysDifferByTheirLightness) {
  // L = 116 cbrt(Y) - 16; both errors are below the knee of the mapping.
  const double expected = constantColourError(116.0 * (std::cbrt(0.3) - std::cbrt(0.2)));
  EXPECT_NEAR(flipError(constantImage(20, 20, {0.3f, 0.3f, 0.3f, 1.0f}), constantImage(20, 20, kGray)), expected, 1e-5);
}

TEST(Flip, GreenAgainstBlueIsOne) {
  EXPECT_NEAR(flipError(constantImage(5, 5, {0, 1, 0, 1}), constantImage(5, 5, {0, 0, 1, 1})), 1.0, 1e-6);
}

TEST(Flip, SinglePixelsAndSingleRowsAreConstantImages) {
  const double expected = flipError(constantImage(40, 40, kBlack), constantImage(40, 40, kGray));
  for (const auto& [w, h] : {std::pair(1u, 1u), std::pair(1u, 77u), std::pair(77u, 1u), std::pair(3u, 2u)})
    EXPECT_NEAR(flipError(constantImage(w, h, kBlack), constantImage(w, h, kGray)), expected, 1e-6) << w << "x" << h;
}

// --- Properties ------------------------------------------------------------------------------------------------------

TEST(Flip, IsSymmetricAndWithinZeroToOne) {
  const Image a = withNoise(smoothImage(50, 40), 1.0f, 1);
  const Image b = withNoise(smoothImage(50, 40), 1.0f, 2);
  EXPECT_GT(flipError(a, b), 0.0);
  EXPECT_LT(flipError(a, b), 1.0);
  EXPECT_NEAR(flipError(a, b), flipError(b, a), 1e-15);
}

TEST(Flip, GrowsWithThePerturbation) {
  const Image image = smoothImage(48, 48);
  double last = 0.0;
  for (const float size : {0.001f, 0.01f, 0.03f, 0.1f, 0.3f}) {
    const double error = flipError(image, withNoise(image, size, 3));
    EXPECT_GT(error, last) << size;
    last = error;
  }
}

Image edgeImage(std::uint32_t edge) {
  Image image = constantImage(64, 64, kGray);
  for (std::uint32_t y = 0; y < image.height; y++) {
    for (std::uint32_t x = edge; x < image.width; x++) image.at(x, y) = kWhite;
  }
  return image;
}

TEST(Flip, ShiftedEdgeIsFoundAndMoreSoTheFartherItMoved) {
  const double one = flipError(edgeImage(30), edgeImage(31));
  const double four = flipError(edgeImage(30), edgeImage(34));
  EXPECT_GT(one, 0.005);
  EXPECT_GT(four, 1.5 * one);
}

TEST(Flip, TurnedImagesHaveTheSameError) {
  const Image a = withNoise(smoothImage(37, 21), 0.2f, 4);
  const Image b = withNoise(smoothImage(37, 21), 0.2f, 5);
  const auto turned = [](const Image& image) {
    Image result(image.height, image.width);
    for (std::uint32_t y = 0; y < image.height; y++) {
      for (std::uint32_t x = 0; x < image.width; x++) result.at(image.height - 1 - y, x) = image.at(x, y);
    }
    return result;
  };
  EXPECT_NEAR(flipError(turned(a), turned(b)), flipError(a, b), 1e-9);
}

TEST(Flip, FinePatternCountsLessThanACoarseOneOfTheSameContrast) {
  // Contrast sensitivity: a checkerboard of single pixels is seen as its mean.
  const auto board = [](std::uint32_t cell) {
    Image image = constantImage(64, 64, kBlack);
    for (std::uint32_t y = 0; y < 64; y++) {
      for (std::uint32_t x = 0; x < 64; x++) {
        if ((x / cell + y / cell) % 2 == 0) image.at(x, y) = {0.4f, 0.4f, 0.4f, 1.0f};
      }
    }
    return image;
  };
  const Image mean = constantImage(64, 64, kGray);
  EXPECT_LT(flipError(mean, board(1)), 0.5 * flipError(mean, board(8)));
}

TEST(Flip, ColoursBeyondTheScaleAreClampedAndNanIsBlack) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(flipError(constantImage(9, 9, {nan, -5.0f, -infinity, nan}), constantImage(9, 9, kBlack)), 0.0);
  EXPECT_EQ(flipError(constantImage(9, 9, {infinity, 3.0f, 1.0f, nan}), constantImage(9, 9, kWhite)), 0.0);
}

// --- The same from the two-dimensional definition --------------------------------------------------------------------

// FLIP of one pixel, straight from the paper: square kernels as they are printed there, summed pixel by pixel, without
// the separation, the mirroring and the bands of the library.
class DirectFlip {
 public:
  DirectFlip(const Image& reference, const Image& test) : reference_(reference), test_(test) {}

  double mean() const {
    double sum = 0.0;
    for (int y = 0; y < static_cast<int>(reference_.height); y++) {
      for (int x = 0; x < static_cast<int>(reference_.width); x++) sum += error(x, y);
    }
    return sum / static_cast<double>(reference_.pixels.size());
  }

 private:
  static constexpr double kPerDegree = 67.0;

  static glm::dvec3 opponent(const Image& image, int x, int y) {
    x = std::clamp(x, 0, static_cast<int>(image.width) - 1);
    y = std::clamp(y, 0, static_cast<int>(image.height) - 1);
    const glm::dvec3 rgb =
        glm::clamp(glm::dvec3(image.at(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))), 0.0, 1.0);
    const glm::dvec3 xyz = relativeXyzFromRgb() * rgb;
    return {116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z)};
  }

  static double sensitivity(double degrees2, double a1, double b1, double a2, double b2) {
    const double pi = std::numbers::pi;
    return a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * degrees2 / b1) +
           a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * degrees2 / b2);
  }

  static glm::dvec3 filteredLab(const Image& image, int x, int y) {
    glm::dvec3 sum(0.0);
    glm::dvec3 weights(0.0);
    for (int j = -10; j <= 10; j++) {
      for (int i = -10; i <= 10; i++) {
        const double degrees2 = (i * i + j * j) / (kPerDegree * kPerDegree);
        const glm::dvec3 weight(sensitivity(degrees2, 1.0, 0.0047, 0.0, 1e-5),
                                sensitivity(degrees2, 1.0, 0.0053, 0.0, 1e-5),
                                sensitivity(degrees2, 34.1, 0.04, 13.5, 0.025));
        sum += weight * opponent(image, x + i, y + j);
        weights += weight;
      }
    }
    const glm::dvec3 c = sum / weights;
    const double white = (c.x + 16.0) / 116.0;
    const glm::dvec3 rgb = rgbFromRelativeXyz() * glm::dvec3(white + c.y / 500.0, white, white - c.z / 200.0);
    return hunt(glm::clamp(rgb, 0.0, 1.0));
  }

  static glm::dvec3 hunt(const glm::dvec3& rgb) {
    const glm::dvec3 lab = labFromRelativeXyz(relativeXyzFromRgb() * rgb);
    return {lab.x, lab.y * 0.01 * lab.x, lab.z * 0.01 * lab.x};
  }

  static double hyab(const glm::dvec3& a, const glm::dvec3& b) {
    return std::abs(a.x - b.x) + glm::length(glm::dvec2(a.y - b.y, a.z - b.z));
  }

  // Length of a feature filter's answer; the filter is that along x and its transpose.
  static double feature(const Image& image, int x, int y, bool point) {
    const double sd = 0.5 * 0.082 * kPerDegree;
    glm::dvec2 positive(0.0), negative(0.0);
    double positiveWeight = 0.0, negativeWeight = 0.0;
    for (int j = -9; j <= 9; j++) {
      for (int i = -9; i <= 9; i++) {
        const double g = std::exp(-(i * i + j * j) / (2.0 * sd * sd));
        const double weight = point ? (i * i / (sd * sd) - 1.0) * g : -i * g;
        const glm::dvec2 values((opponent(image, x + i, y + j).x + 16.0) / 116.0,
                                (opponent(image, x + j, y + i).x + 16.0) / 116.0);
        (weight > 0.0 ? positive : negative) += weight * values;
        (weight > 0.0 ? positiveWeight : negativeWeight) += std::abs(weight);
      }
    }
    return glm::length(positive / positiveWeight + negative / negativeWeight);
  }

  double error(int x, int y) const {
    const double largest = std::pow(hyab(hunt({0, 1, 0}), hunt({0, 0, 1})), 0.7);
    const double distance = std::pow(hyab(filteredLab(reference_, x, y), filteredLab(test_, x, y)), 0.7);
    const double knee = 0.4 * largest;
    const double colour = distance < knee ? 0.95 / knee * distance : 0.95 + (distance - knee) / (largest - knee) * 0.05;
    const double edges = std::abs(feature(reference_, x, y, false) - feature(test_, x, y, false));
    const double points = std::abs(feature(reference_, x, y, true) - feature(test_, x, y, true));
    const double features = std::pow(std::max(edges, points) / std::sqrt(2.0), 0.5);
    return std::pow(colour, 1.0 - features);
  }

  const Image& reference_;
  const Image& test_;
};

TEST(Flip, AgreesWithTheTwoDimensionalDefinition) {
  // 35 rows: two bands. Noise of single pixels reaches every weight; the second image moves an edge, too.
  for (const auto& [w, h] : {std::pair(13u, 35u), std::pair(31u, 4u)}) {
    const Image a = withNoise(smoothImage(w, h), 0.5f, 11);
    Image b = withNoise(smoothImage(w, h), 0.4f, 12);
    for (std::uint32_t y = 0; y < h; y++) b.at(w / 2, y) = {0.0f, 1.0f, 0.0f, 1.0f};
    EXPECT_NEAR(flipError(a, b), DirectFlip(a, b).mean(), 1e-9) << w << "x" << h;
  }
}

}  // namespace
}  // namespace tetralux
