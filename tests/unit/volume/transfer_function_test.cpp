#include "volume/transfer_function.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/expect_error.h"

namespace tetralux {
namespace {

using test::errorOf;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const TransferFunction& ramp() {
  static const TransferFunction transfer({{1.0, {0, 0, 0}, 2.0}, {3.0, {1, 0.5, 0.25}, 6.0}}, "t");
  return transfer;
}

TEST(TransferFunction, IsLinearBetweenPointsAndConstantOutside) {
  EXPECT_EQ(ramp().at(2.0).extinction, 4.0);
  EXPECT_EQ(ramp().at(1.5).luminance, glm::dvec3(0.25, 0.125, 0.0625));
  EXPECT_EQ(ramp().at(1.0).extinction, 2.0);
  EXPECT_EQ(ramp().at(3.0).extinction, 6.0);
  EXPECT_EQ(ramp().at(-1e300).extinction, 2.0);
  EXPECT_EQ(ramp().at(kInfinity).extinction, 6.0);
}

TEST(TransferFunction, PiecesCoverAllScalars) {
  const auto& pieces = ramp().pieces();
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces.front().low, -kInfinity);
  EXPECT_EQ(pieces.back().high, kInfinity);
  for (size_t i = 1; i < pieces.size(); i++) EXPECT_EQ(pieces[i].low, pieces[i - 1].high);
}

TEST(TransferFunction, OnAStepTheValuesAfterItHold) {
  const TransferFunction step({{0, {}, 1}, {1, {}, 1}, {1, {}, 9}, {1, {}, 5}, {2, {}, 5}}, "t");
  EXPECT_EQ(step.at(std::nextafter(1.0, 0.0)).extinction, 1.0);
  EXPECT_EQ(step.at(1.0).extinction, 5.0);  // a third point at the same place hides the second
  EXPECT_EQ(step.pieces().size(), 4u);
}

TEST(TransferFunction, OnePointIsAConstant) {
  const TransferFunction constant({{7, {1, 2, 3}, 4}}, "t");
  for (const double s : {-1.0, 7.0, 8.0}) EXPECT_EQ(constant.at(s).extinction, 4.0);
}

TEST(TransferFunction, ScalingChangesExtinctionOnly) {
  const TransferFunction scaled = ramp().scaled(0.5);
  EXPECT_EQ(scaled.at(2.0).extinction, 2.0);
  EXPECT_EQ(scaled.at(2.0).luminance, ramp().at(2.0).luminance);
  EXPECT_EQ(scaled.largestExtinction(), 3.0);
}

TEST(TransferFunction, EmissionIsKeptWhenExtinctionIsScaled) {
  EXPECT_EQ(ramp().emission(), Emission::PerExtinction);
  const TransferFunction glow(ramp().points(), "t", Emission::PerLength);
  EXPECT_EQ(glow.scaled(2).emission(), Emission::PerLength);
  EXPECT_EQ(glow.scaled(2).at(2.0).luminance, glow.at(2.0).luminance);
  EXPECT_EQ(errorOf(ErrorCode::Input, [&] { ramp().scaled(1e308); }),
            "scaled transfer function: point 0: tau is inf, expected a finite number >= 0");
}

TEST(TransferFunction, DefectsAreNamed) {
  const auto error = [](std::vector<ControlPoint> points) {
    return errorOf(ErrorCode::Input, [&] { TransferFunction(points, "f: points"); });
  };
  EXPECT_EQ(error({}), "f: points: has no point, expected at least one");
  EXPECT_EQ(error({{0, {}, 1}, {-1, {}, 1}}),
            "f: points: point 1: s is -1, expected at least that of the point before, 0");
  EXPECT_EQ(error({{0, {}, -1}}), "f: points: point 0: tau is -1, expected a finite number >= 0");
  EXPECT_EQ(error({{0, {0, -0.5, 0}, 1}}), "f: points: point 0: rgb[1] is -0.5, expected a finite number >= 0");
  EXPECT_EQ(error({{kInfinity, {}, 1}}), "f: points: point 0: s is inf, expected a finite number");
}

}  // namespace
}  // namespace tetralux
