#include "chart/false_color.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/color.h"
#include "support/expect_error.h"

namespace tetralux::chart {
namespace {

double lightness(const glm::dvec3& linear) { return labFromRelativeXyz(relativeXyzFromRgb() * linear).x; }

TEST(FalseColor, LightnessRisesEvenly) {
  for (int i = 0; i <= 42; i++) {
    const double share = i / 42.0;
    EXPECT_NEAR(lightness(colorOfShare(share)), 100.0 * share, 0.2) << share;
  }
}

TEST(FalseColor, ADecadeIsAsManyStepsAsAnyOther) {
  for (int decade = kLowestDecade; decade <= 0; decade++) {
    const double expected = 100.0 * (1.0 - static_cast<double>(decade) / kLowestDecade);
    EXPECT_NEAR(lightness(colorOfDifference(std::pow(10.0, decade))), expected, 0.2) << decade;
  }
  EXPECT_EQ(colorOfDifference(0.0), colorOfShare(0.0));
  EXPECT_EQ(colorOfDifference(1e-12), colorOfShare(0.0));
  EXPECT_EQ(colorOfDifference(7.0), colorOfShare(1.0));
  EXPECT_EQ(colorOfDifference(std::nan("")), colorOfShare(1.0));
}

TEST(DifferencePicture, ShowsTheLargestOfFourChannels) {
  Image a(2, 2);
  Image b(2, 2);
  b.at(1, 0) = {0.0f, -0.01f, 0.001f, 0.0f};
  b.at(0, 1) = {0.0f, 0.0f, 0.0f, 0.1f};
  b.at(1, 1).x = std::numeric_limits<float>::quiet_NaN();
  const Image picture = differencePicture(a, b);
  const auto expected = [](double difference) { return glm::vec4(glm::dvec4(colorOfDifference(difference), 1.0)); };
  EXPECT_EQ(picture.at(0, 0), expected(0.0));
  EXPECT_EQ(picture.at(1, 0), expected(0.01));
  EXPECT_EQ(picture.at(0, 1), expected(0.1));
  EXPECT_EQ(picture.at(1, 1), expected(1.0));
}

TEST(DifferencePicture, SizesMustAgree) {
  EXPECT_EQ(test::errorOf(ErrorCode::Input, [] { differencePicture(Image(2, 2), Image(2, 3)); }),
            "images of different size: 2 x 3 pixels, expected 2 x 2 like the reference");
}

}  // namespace
}  // namespace tetralux::chart
