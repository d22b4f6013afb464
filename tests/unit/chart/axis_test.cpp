#include "chart/axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "chart/svg_text.h"

namespace tetralux::chart {
namespace {

// Whether a value is 1, 2 or 5 times a power of ten.
bool isRound(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
  const double factor = value / power;
  return std::abs(factor - 1.0) < 1e-9 || std::abs(factor - 2.0) < 1e-9 || std::abs(factor - 5.0) < 1e-9;
}

TEST(LogarithmicAxis, HoldsAllValuesBetweenRoundEnds) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-8.0, 6.0);
  for (int i = 0; i < 200; i++) {
    const std::vector<double> values = {std::pow(10.0, exponent(random)), std::pow(10.0, exponent(random))};
    const Axis axis = Axis::logarithmic(values);
    EXPECT_TRUE(isRound(axis.low())) << axis.low();
    EXPECT_TRUE(isRound(axis.high())) << axis.high();
    for (const double value : values) {
      EXPECT_GT(axis.share(value), 0.0) << value;
      EXPECT_LT(axis.share(value), 1.0) << value;
    }
    EXPECT_LE(axis.high(), 5.5 * std::max(values[0], values[1]));
    EXPECT_GE(axis.low(), std::min(values[0], values[1]) / 5.5);
  }
}

TEST(LogarithmicAxis, EveryDecadeWithinHasATick) {
  const Axis axis = Axis::logarithmic({3e-6, 0.04});
  for (const double decade : {1e-5, 1e-4, 1e-3, 1e-2}) {
    int found = 0;
    for (const Tick& tick : axis.ticks()) found += std::abs(tick.value / decade - 1.0) < 1e-9 && !tick.text.empty();
    EXPECT_EQ(found, 1) << decade;
  }
  for (const Tick& tick : axis.ticks()) {
    EXPECT_GE(tick.value, axis.low() * (1.0 - 1e-9));
    EXPECT_LE(tick.value, axis.high() * (1.0 + 1e-9));
  }
}

TEST(LogarithmicAxis, ADecadeIsAsLongAsAnyOther) {
  const Axis axis = Axis::logarithmic({1.5, 800.0});
  EXPECT_NEAR(axis.share(100.0) - axis.share(10.0), axis.share(20.0) - axis.share(2.0), 1e-12);
}

TEST(LogarithmicAxis, ZeroAndNonFiniteValuesDoNotCount) {
  const Axis axis = Axis::logarithmic({0.0, 3.0, std::nan(""), INFINITY, 30.0, -5.0});
  EXPECT_EQ(axis.low(), Axis::logarithmic({3.0, 30.0}).low());
  EXPECT_EQ(axis.high(), Axis::logarithmic({3.0, 30.0}).high());
  EXPECT_GT(Axis::logarithmic({}).high(), Axis::logarithmic({}).low());
  EXPECT_GT(Axis::logarithmic({7.0}).high(), Axis::logarithmic({7.0}).low());
}

TEST(LinearAxis, BeginsAtZeroAndHasAFewRoundTicks) {
  for (const double largest : {0.003, 1.0, 7.0, 376000.0}) {
    const Axis axis = Axis::linearFromZero({0.5 * largest, largest});
    EXPECT_EQ(axis.low(), 0.0);
    EXPECT_GE(axis.high(), largest * (1.0 - 1e-9));
    EXPECT_GE(axis.ticks().size(), 3u) << largest;
    EXPECT_LE(axis.ticks().size(), 8u) << largest;
    EXPECT_TRUE(isRound(axis.ticks()[1].value)) << largest;
  }
}

TEST(NumberText, IsShortAndExact) {
  EXPECT_EQ(numberText(0.0), "0");
  EXPECT_EQ(numberText(0.5), "0.5");
  EXPECT_EQ(numberText(0.001), "0.001");
  EXPECT_EQ(numberText(2000.0), "2000");
  EXPECT_EQ(numberText(50000.0), "50\u202fk");
  EXPECT_EQ(numberText(2e6), "2\u202fM");
  EXPECT_EQ(numberText(1e-6), "10⁻⁶");
  EXPECT_EQ(numberText(5e-5), "5·10⁻⁵");
  EXPECT_EQ(numberText(1e12), "10¹²");
}

}  // namespace
}  // namespace tetralux::chart
