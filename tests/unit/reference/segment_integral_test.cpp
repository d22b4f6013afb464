#include "reference/segment_integral.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tetralux::reference {
namespace {

// Closed forms of V = Psi - zeta where they are well conditioned.
double closedMoment(double front, double back) {
  const double zeta = std::exp(-0.5 * (front + back));
  if (front == back) return (1.0 - zeta) / front - zeta;
  // Williams and Max 1992 for a growing extinction; F is Dawson's integral by its Maclaurin series for small arguments.
  const double c = 0.5 * std::abs(back - front);
  const double pi = std::acos(-1.0);
  if (back > front) {
    const double r = 1.0 / (2.0 * std::sqrt(c));
    const auto erfcx = [](double x) { return std::exp(x * x) * std::erfc(x); };
    return std::sqrt(pi) * r * (erfcx(front * r) - zeta * erfcx(back * r)) - zeta;
  }
  const auto dawson = [](double x) {
    double sum = 0.0;
    double term = x;
    for (int n = 0; n < 200; n++) {
      sum += term;
      term *= -2.0 * x * x / (2 * n + 3);
    }
    return sum;
  };
  const double r = 1.0 / (2.0 * std::sqrt(c));
  return (dawson(front * r) - zeta * dawson(back * r)) / std::sqrt(c) - zeta;
}

TEST(EmissionMoment, AgreesWithClosedForms) {
  for (const double front : {0.0, 0.1, 1.0, 3.0}) {
    for (const double back : {0.0, 0.3, 1.0, 2.5, 6.0}) {
      if (front == 0.0 && back == 0.0) continue;
      // The closed forms subtract two larger numbers; their own rounding is up to 6e-14 here.
      EXPECT_NEAR(emissionMoment(front, back), closedMoment(front, back), 1e-13) << front << " " << back;
    }
  }
}

TEST(EmissionMoment, OpaqueLimits) {
  EXPECT_NEAR(emissionMoment(1e6, 1e6), 1e-6, 1e-15);
  EXPECT_NEAR(emissionMoment(1e6, 0.0), 1e-6, 2e-12);  // 1/b (1 + O(c/b^2))
  EXPECT_NEAR(emissionMoment(0.0, 1e6), std::sqrt(std::acos(-1.0) / 2e6), 1e-12);
}

TEST(EmissionMoment, ThinLimitHasASmallRelativeError) {
  // V = a/3 + b/6 to first order (a back, b front).
  for (const double m : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const double expected = 2.0 * m / 3 + 0.5 * m / 6;
    EXPECT_NEAR(emissionMoment(0.5 * m, 2.0 * m) / expected, 1.0, 2 * m + 1e-14);
  }
  EXPECT_EQ(emissionMoment(0.0, 0.0), 0.0);
}

TEST(EmissionMoment, LiesBetweenZeroAndTheOpacity) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-8, 8);
  for (int i = 0; i < 20000; i++) {
    const double front = std::pow(10.0, exponent(random));
    const double back = std::pow(10.0, exponent(random));
    const double v = emissionMoment(front, back);
    EXPECT_GE(v, 0.0);
    EXPECT_LE(v, -std::expm1(-0.5 * (front + back)) * (1 + 1e-14));
  }
}

const TransferFunction& wavy() {
  static const TransferFunction transfer({{0.1, {1, 0, 0.2}, 0.5},
                                          {0.2, {0.5, 1, 0}, 3},
                                          {0.35, {0, 0.3, 1}, 0},
                                          {0.6, {0, 0.3, 1}, 0},
                                          {0.6, {1, 1, 1}, 8},
                                          {0.9, {0.2, 0, 0}, 1}},
                                         "wavy");
  return transfer;
}

// Midpoint rule with many steps: slow, but nothing to get wrong.
SegmentOptics brute(const TransferFunction& transfer, double front, double back, double length) {
  constexpr int kSteps = 400000;
  SegmentOptics result;
  double transmittance = 1.0;
  for (int i = 0; i < kSteps; i++) {
    const OpticalSample sample = transfer.at(front + (back - front) * (i + 0.5) / kSteps);
    const double alpha = -std::expm1(-sample.extinction * length / kSteps);
    result.light += transmittance * alpha * sample.luminance;
    transmittance *= 1.0 - alpha;
  }
  result.alpha = 1.0 - transmittance;
  return result;
}

TEST(IntegrateSegment, AgreesWithBruteForceAcrossControlPoints) {
  for (const auto& [front, back] :
       {std::pair(0.0, 1.0), std::pair(1.0, 0.0), std::pair(0.15, 0.65), std::pair(0.95, 0.33)}) {
    const SegmentOptics exact = integrateSegment(wavy(), front, back, 1.7);
    const SegmentOptics expected = brute(wavy(), front, back, 1.7);
    for (int c = 0; c < 3; c++) EXPECT_NEAR(exact.light[c], expected.light[c], 2e-6);
    EXPECT_NEAR(exact.alpha, expected.alpha, 2e-6);
  }
}

TEST(IntegrateSegment, PartsCompositeToTheWhole) {
  for (const double length : {1e-6, 0.3, 20.0}) {
    for (const auto& [front, back] : {std::pair(0.0, 1.0), std::pair(0.97, 0.02)}) {
      const SegmentOptics whole = integrateSegment(wavy(), front, back, length);
      SegmentOptics sum;
      constexpr int kParts = 137;
      for (int i = 0; i < kParts; i++) {
        const auto at = [&](int k) { return front + (back - front) * k / kParts; };
        const SegmentOptics part = integrateSegment(wavy(), at(i), at(i + 1), length / kParts);
        sum.light += (1.0 - sum.alpha) * part.light;
        sum.alpha += (1.0 - sum.alpha) * part.alpha;
      }
      for (int c = 0; c < 3; c++) EXPECT_NEAR(whole.light[c], sum.light[c], 1e-13);
      EXPECT_NEAR(whole.alpha, sum.alpha, 1e-13);
    }
  }
}

TEST(IntegrateSegment, OpacityDoesNotDependOnDirection) {
  EXPECT_NEAR(integrateSegment(wavy(), 0.05, 0.8, 2).alpha, integrateSegment(wavy(), 0.8, 0.05, 2).alpha, 1e-15);
}

TEST(IntegrateSegment, ConstantScalarIsTheHomogeneousFormula) {
  const OpticalSample sample = wavy().at(0.15);
  const SegmentOptics optics = integrateSegment(wavy(), 0.15, 0.15, 0.9);
  const double alpha = 1.0 - std::exp(-sample.extinction * 0.9);
  EXPECT_NEAR(optics.alpha, alpha, 1e-15);
  EXPECT_NEAR(optics.light.x, sample.luminance.x * alpha, 1e-15);
}

// X from Psi by integration by parts, (a - b) X = 1 - zeta - b Psi, where a and b are far apart.
TEST(LengthMoments, AgreeWithClosedForms) {
  for (const double front : {0.0, 0.1, 1.0, 3.0}) {
    for (const double back : {0.0, 0.3, 1.0, 2.5, 6.0}) {
      const LengthMoments moments = lengthMoments(front, back);
      const double zeta = std::exp(-0.5 * (front + back));
      if (std::abs(front - back) < 0.15) continue;
      EXPECT_NEAR(moments.even, closedMoment(front, back) + zeta, 1e-13) << front << " " << back;
      EXPECT_NEAR(moments.linear, (1.0 - zeta - front * moments.even) / (back - front), 1e-12) << front << " " << back;
    }
  }
}

TEST(LengthMoments, WithoutExtinctionAllLightArrives) {
  EXPECT_NEAR(lengthMoments(0.0, 0.0).even, 1.0, 1e-15);
  EXPECT_NEAR(lengthMoments(0.0, 0.0).linear, 0.5, 1e-15);
  // Psi = 1 - b/3 - a/6, X = 1/2 - 5 b/24 - a/8 to first order (a back, b front).
  for (const double m : {1e-3, 1e-6, 1e-9}) {
    const LengthMoments thin = lengthMoments(0.5 * m, 2.0 * m);
    EXPECT_NEAR(thin.even, 1.0 - 0.5 * m / 3 - 2.0 * m / 6, 2 * m * m + 1e-15);
    EXPECT_NEAR(thin.linear, 0.5 - 5 * 0.5 * m / 24 - 2.0 * m / 8, 2 * m * m + 1e-15);
  }
}

TEST(LengthMoments, OpaqueLimits) {
  EXPECT_NEAR(lengthMoments(1e6, 1e6).even, 1e-6, 1e-18);
  EXPECT_NEAR(lengthMoments(1e6, 1e6).linear, 1e-12, 1e-22);
  EXPECT_NEAR(lengthMoments(0.0, 1e6).even, std::sqrt(std::acos(-1.0) / 2e6), 1e-12);
  EXPECT_NEAR(lengthMoments(0.0, 1e6).linear, 1e-6, 1e-15);
}

const TransferFunction& glow() {
  static const TransferFunction transfer(wavy().points(), "glow", Emission::PerLength);
  return transfer;
}

TEST(IntegrateSegment, EmissionPerLengthOfAConstantScalarIsTheHomogeneousFormula) {
  const TransferFunction transfer({{0, {2, 0.5, 0}, 0}, {1, {2, 0.5, 4}, 3}}, "t", Emission::PerLength);
  for (const double s : {0.0, 1e-9, 0.25, 1.0}) {
    for (const double length : {1e-6, 0.9, 30.0}) {
      const SegmentOptics optics = integrateSegment(transfer, s, s, length);
      const double tau = 3 * s;
      const double reach = tau == 0.0 ? length : -std::expm1(-tau * length) / tau;
      EXPECT_NEAR(optics.light.x / (2 * reach), 1.0, 1e-13) << s << " " << length;
      EXPECT_NEAR(optics.light.z, 4 * s * reach, 1e-13 * length);
      EXPECT_NEAR(optics.alpha, -std::expm1(-tau * length), 1e-15);
    }
  }
}

TEST(IntegrateSegment, EmissionPerLengthAgreesWithBruteForceAcrossControlPoints) {
  for (const auto& [front, back] :
       {std::pair(0.0, 1.0), std::pair(1.0, 0.0), std::pair(0.15, 0.65), std::pair(0.95, 0.33), std::pair(0.4, 0.55)}) {
    const double length = 1.7;
    const SegmentOptics exact = integrateSegment(glow(), front, back, length);
    constexpr int kSteps = 400000;
    glm::dvec3 light(0.0);
    double depth = 0.0;
    for (int i = 0; i < kSteps; i++) {
      const OpticalSample sample = glow().at(front + (back - front) * (i + 0.5) / kSteps);
      const double step = sample.extinction * length / kSteps;
      light += std::exp(-(depth + 0.5 * step)) * sample.luminance * (length / kSteps);
      depth += step;
    }
    for (int c = 0; c < 3; c++) EXPECT_NEAR(exact.light[c], light[c], 4e-6);
    EXPECT_EQ(exact.alpha, integrateSegment(wavy(), front, back, length).alpha);
  }
}

TEST(IntegrateSegment, EmissionPerLengthOfPartsCompositesToTheWhole) {
  for (const double length : {1e-6, 0.3, 20.0}) {
    const SegmentOptics whole = integrateSegment(glow(), 0.97, 0.02, length);
    SegmentOptics sum;
    constexpr int kParts = 137;
    for (int i = 0; i < kParts; i++) {
      const auto at = [&](int k) { return 0.97 + (0.02 - 0.97) * k / kParts; };
      const SegmentOptics part = integrateSegment(glow(), at(i), at(i + 1), length / kParts);
      sum.light += (1.0 - sum.alpha) * part.light;
      sum.alpha += (1.0 - sum.alpha) * part.alpha;
    }
    for (int c = 0; c < 3; c++) EXPECT_NEAR(whole.light[c], sum.light[c], 1e-13 * std::max(1.0, length));
  }
}

// Light that does not absorb shows through everything that does not either, and is added up.
TEST(IntegrateSegment, EmissionPerLengthNeedsNoExtinction) {
  const TransferFunction transfer({{0, {1, 2, 3}, 0}, {1, {3, 2, 1}, 0}}, "t", Emission::PerLength);
  const SegmentOptics optics = integrateSegment(transfer, 0, 1, 5);
  for (int c = 0; c < 3; c++) EXPECT_NEAR(optics.light[c], 10.0, 1e-13);
  EXPECT_EQ(optics.alpha, 0.0);
}

TEST(IntegrateSegment, NoLengthIsNothing) {
  const SegmentOptics optics = integrateSegment(wavy(), 0.0, 1.0, 0.0);
  EXPECT_EQ(optics.alpha, 0.0);
  EXPECT_EQ(optics.light, glm::dvec3(0.0));
}

}  // namespace
}  // namespace tetralux::reference
