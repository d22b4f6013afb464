#include "image/color.h"

#include <gtest/gtest.h>

namespace tetralux {
namespace {

TEST(Srgb, CurveHasTheStandardsValues) {
  EXPECT_EQ(srgbFromLinear(0.0), 0.0);
  EXPECT_NEAR(srgbFromLinear(1.0), 1.0, 1e-15);
  EXPECT_NEAR(srgbFromLinear(0.001), 0.01292, 1e-15);
  EXPECT_NEAR(srgbFromLinear(0.2140411), 0.5, 1e-7);  // middle of the encoded scale
  EXPECT_NEAR(linearFromSrgb(0.5), 0.2140411, 1e-7);
  EXPECT_NEAR(linearFromSrgb(0.04), 0.04 / 12.92, 1e-15);
}

TEST(Srgb, BothSidesOfTheKneeMeet) {
  // The standard rounds the knee; the curve jumps there by less than 1e-7, the inverse by less than 1e-8.
  EXPECT_NEAR(srgbFromLinear(0.0031308), srgbFromLinear(0.0031308 * (1.0 + 1e-12)), 1e-7);
  EXPECT_NEAR(linearFromSrgb(0.04045), linearFromSrgb(0.04045 * (1.0 + 1e-12)), 1e-7);
}

TEST(Srgb, CurvesAreInverse) {
  for (int i = 0; i <= 255; i++) EXPECT_NEAR(srgbFromLinear(linearFromSrgb(i / 255.0)), i / 255.0, 1e-6) << i;
}

TEST(Xyz, MatrixIsThatOfTheStandard) {
  // IEC 61966-2-1 prints the matrix with four digits; white is (0.9505, 1, 1.0890) there.
  const double rows[3][3] = {{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};
  const double white[3] = {0.9505, 1.0, 1.0890};
  for (int row = 0; row < 3; row++) {
    for (int column = 0; column < 3; column++)
      EXPECT_NEAR(relativeXyzFromRgb()[column][row], rows[row][column] / white[row], 1e-4) << row << column;
  }
}

TEST(Xyz, WhiteIsTheUnit) {
  const glm::dvec3 white = relativeXyzFromRgb() * glm::dvec3(1.0);
  for (int c = 0; c < 3; c++) EXPECT_NEAR(white[c], 1.0, 1e-14);
  const glm::dvec3 back = rgbFromRelativeXyz() * white;
  for (int c = 0; c < 3; c++) EXPECT_NEAR(back[c], 1.0, 1e-14);
}

TEST(Lab, BlackAndWhiteEndTheLightnessScale) {
  const glm::dvec3 black = labFromRelativeXyz(glm::dvec3(0.0));
  const glm::dvec3 white = labFromRelativeXyz(glm::dvec3(1.0));
  for (int c = 0; c < 3; c++) {
    EXPECT_NEAR(black[c], 0.0, 1e-12);
    EXPECT_NEAR(white[c], c == 0 ? 100.0 : 0.0, 1e-12);
  }
}

TEST(Lab, PrimaryGreenIsWhereTablesPutIt) {
  const glm::dvec3 lab = labFromRelativeXyz(relativeXyzFromRgb() * glm::dvec3(0.0, 1.0, 0.0));
  EXPECT_NEAR(lab.x, 87.73, 0.01);
  EXPECT_NEAR(lab.y, -86.18, 0.02);
  EXPECT_NEAR(lab.z, 83.18, 0.02);
}

TEST(Lab, CurveIsSmoothAtItsKnee) {
  const double knee = 216.0 / 24389.0;
  const double below = labFromRelativeXyz(glm::dvec3(knee * (1.0 - 1e-9))).x;
  const double above = labFromRelativeXyz(glm::dvec3(knee * (1.0 + 1e-9))).x;
  EXPECT_NEAR(below, 8.0, 1e-6);
  EXPECT_NEAR(above, 8.0, 1e-6);
}

}  // namespace
}  // namespace tetralux
