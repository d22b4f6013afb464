#include "volume/factor_curve.h"

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace tetralux {
namespace {

using test::errorOf;

TEST(FactorCurve, IsLinearBetweenPointsAndConstantOutside) {
  const FactorCurve curve({{1.0, 0.0, {1.0, 0.0, 0.0}}, {3.0, 4.0, {0.0, 1.0, 0.0}}}, "f");
  EXPECT_EQ(curve.at(0.0).factor, 0.0);
  EXPECT_EQ(curve.at(1.5).factor, 1.0);
  EXPECT_EQ(curve.at(1.5).rgb, glm::dvec3(0.75, 0.25, 0.0));
  EXPECT_EQ(curve.at(9.0).factor, 4.0);
}

TEST(FactorCurve, AValueOnAStepTakesWhatComesAfter) {
  const FactorCurve curve({{0.0, 1.0}, {1.0, 2.0}, {1.0, 5.0}, {2.0, 5.0}}, "f");
  EXPECT_EQ(curve.at(1.0).factor, 5.0);
  EXPECT_NEAR(curve.at(1.0 - 1e-12).factor, 2.0, 1e-9);
}

TEST(FactorCurve, SaysWhatIsWrong) {
  const auto message = [](std::vector<FactorPoint> points) {
    return errorOf(ErrorCode::Input, [&] { FactorCurve(std::move(points), "place"); });
  };
  EXPECT_EQ(message({}), "place: has no point, expected at least one");
  EXPECT_EQ(message({{0.0, -1.0}}), "place: point 0: factor is -1, expected a finite number >= 0");
  EXPECT_EQ(message({{1.0}, {0.5}}), "place: point 1: found 0.5, expected at least the value of the point before, 1");
}

}  // namespace
}  // namespace tetralux
