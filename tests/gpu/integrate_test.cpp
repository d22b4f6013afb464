// include/integration/exact.glsl against the double-precision integral, segment by segment.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gpu_fixture.h"
#include "reference/segment_integral.h"
#include "segments.h"

namespace tetralux::render {
namespace {

using test::GpuTest;
using test::integrateOnDevice;
using test::largestError;
using test::largestRelativeError;
using test::Segment;

const TransferFunction& ramp() {
  static const TransferFunction transfer({{0, {1, 0, 0.5}, 0}, {1, {0, 1, 0.5}, 1}}, "ramp");
  return transfer;
}

const TransferFunction& peaks() {
  // All control points are multiples of 1/256: exact in single precision, after normalisation too.
  static const TransferFunction transfer({{0 / 256.0, {0.1, 0.2, 0.9}, 0},
                                          {76 / 256.0, {0.1, 0.2, 0.9}, 0},
                                          {77 / 256.0, {0.9, 0.2, 0.1}, 9},
                                          {78 / 256.0, {0.1, 0.2, 0.9}, 0},
                                          {153 / 256.0, {0.5, 0.9, 0.1}, 0},
                                          {154 / 256.0, {0.5, 0.9, 0.1}, 20},
                                          {155 / 256.0, {0.5, 0.9, 0.1}, 0},
                                          {204 / 256.0, {1, 1, 1}, 0.2},
                                          {204 / 256.0, {0, 0, 0}, 3},
                                          {1, {1, 0, 0}, 5}},
                                         "peaks");
  return transfer;
}

// End extinctions a and b over sixteen decades: every branch of NUMERICS section 6.1.
TEST_F(GpuTest, IntegralIsAccurateForAllOpticalDepths) {
  std::vector<Segment> segments;
  for (double exponent = -8; exponent <= 8; exponent += 0.25) {
    const double length = std::pow(10.0, exponent);
    for (const auto& [front, back] :
         {std::pair(0.0, 1.0), std::pair(1.0, 0.0), std::pair(0.5, 0.5), std::pair(1.0, 1.0), std::pair(0.0, 0.0),
          std::pair(1e-6, 1.0), std::pair(0.3, 0.7), std::pair(0.7, 0.3), std::pair(0.5, 0.5 + 1e-6)})
      segments.push_back({front, back, length});
  }
  EXPECT_LE(largestError(context(), ramp(), segments), 1e-5);
}

TEST_F(GpuTest, IntegralIsAccurateForRandomSegments) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Segment> segments;
  for (int i = 0; i < 20000; i++)
    segments.push_back({uniform(random), uniform(random), std::pow(10.0, 4 * uniform(random) - 3)});
  EXPECT_LE(largestError(context(), ramp(), segments), 1e-5);
  // Rounding of a scalar inside a ramp of width 0.004 moves the extinction by 1e-5 of its height.
  EXPECT_LE(largestError(context(), peaks(), segments), 5e-5);
}

TEST_F(GpuTest, IntegralIsAccurateOnAndAroundControlPoints) {
  std::vector<Segment> segments;
  for (const ControlPoint& p : peaks().points()) {
    for (const double offset : {0.0, 1e-7, -1e-7, 1e-5, -1e-5, 1e-3, -1e-3}) {
      for (const double other : {0.0, 1e-7, -1e-7, 1e-4, 0.2, -0.2, 1.0, -1.0}) {
        const double front = std::clamp(p.s + offset, 0.0, 1.0);
        segments.push_back({front, std::clamp(front + other, 0.0, 1.0), 2.0});
      }
    }
  }
  EXPECT_LE(largestError(context(), peaks(), segments), 5e-5);
}

// Thin cells are summed by the thousand: what counts is the relative error.
TEST_F(GpuTest, IntegralOfThinSegmentsHasASmallRelativeError) {
  std::vector<Segment> segments;
  for (const double length : {1e-3, 1e-5, 1e-7, 1e-9}) {
    for (const double front : {0.2, 0.9}) segments.push_back({front, front + 0.05, length});
  }
  const auto found = integrateOnDevice(context(), ramp(), segments);
  for (size_t i = 0; i < segments.size(); i++) {
    const auto& s = segments[i];
    const SegmentOptics expected = reference::integrateSegment(ramp(), s.front, s.back, s.length);
    EXPECT_NEAR(static_cast<double>(found[i].w) / expected.alpha, 1.0, 2e-6);
    EXPECT_NEAR(static_cast<double>(found[i].x) / expected.light.x, 1.0, 4e-6);
  }
}

TEST_F(GpuTest, IntegralOfEqualColorsIsColorTimesOpacity) {
  const TransferFunction transfer({{0, {0.3, 0.6, 0.9}, 0.1}, {0.4, {0.3, 0.6, 0.9}, 7}, {1, {0.3, 0.6, 0.9}, 0}}, "t");
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Segment> segments;
  for (int i = 0; i < 2000; i++) segments.push_back({uniform(random), uniform(random), 10 * uniform(random)});
  for (const glm::vec4& result : integrateOnDevice(context(), transfer, segments)) {
    // Sums of up to twenty parts, in roundings of 6e-8; devices may fuse products and sums or not.
    EXPECT_NEAR(result.x, 0.3f * result.w, 6e-7f);
    EXPECT_NEAR(result.z, 0.9f * result.w, 6e-7f);
    EXPECT_GE(result.w, 0.0f);
    EXPECT_LE(result.w, 1.0f);
  }
}

// What a segment hides does not depend on the side it is seen from.
TEST_F(GpuTest, TurnedSegmentsAreAsOpaque) {
  const TransferFunction transfer({{0, {0.3, 0.6, 0.9}, 0.1}, {0.4, {0.9, 0.1, 0.2}, 7}, {1, {0.1, 0.8, 0.4}, 0}}, "t");
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Segment> segments;
  std::vector<Segment> turned;
  for (int i = 0; i < 2000; i++) {
    segments.push_back({uniform(random), uniform(random), 10 * uniform(random)});
    turned.push_back({segments.back().back, segments.back().front, segments.back().length});
  }
  const auto exact = integrateOnDevice(context(), transfer, segments);
  const auto exactTurned = integrateOnDevice(context(), transfer, turned);
  const auto linear = integrateOnDevice(context(), transfer, segments, Integration::Linear);
  const auto linearTurned = integrateOnDevice(context(), transfer, turned, Integration::Linear);
  for (size_t i = 0; i < segments.size(); i++) {
    EXPECT_NEAR(exact[i].w, exactTurned[i].w, 1e-6f) << i;  // composited from the other end
    EXPECT_EQ(linear[i].w, linearTurned[i].w) << i;         // one closed form
  }
}

TEST_F(GpuTest, EmissionPerLengthIsAccurateForAllOpticalDepths) {
  const TransferFunction glow(ramp().points(), "glow", Emission::PerLength);
  std::vector<Segment> segments;
  for (double exponent = -8; exponent <= 8; exponent += 0.25) {
    const double length = std::pow(10.0, exponent);
    for (const auto& [front, back] :
         {std::pair(0.0, 1.0), std::pair(1.0, 0.0), std::pair(0.5, 0.5), std::pair(1.0, 1.0), std::pair(0.0, 0.0),
          std::pair(1e-6, 1.0), std::pair(0.3, 0.7), std::pair(0.7, 0.3), std::pair(0.5, 0.5 + 1e-6)})
      segments.push_back({front, back, length});
  }
  // The transmittance is a product over up to sixty parts, each right to 3e-6 and rounded: 1.6e-5 in all.
  EXPECT_LE(largestRelativeError(context(), glow, segments), 2.5e-5);
}

TEST_F(GpuTest, EmissionPerLengthIsAccurateForRandomSegments) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Segment> segments;
  for (int i = 0; i < 20000; i++)
    segments.push_back({uniform(random), uniform(random), std::pow(10.0, 4 * uniform(random) - 3)});
  EXPECT_LE(largestRelativeError(context(), TransferFunction(ramp().points(), "t", Emission::PerLength), segments),
            1e-5);
  // Rounding of a scalar inside a ramp of width 0.004 moves the extinction by 1e-5 of its height.
  EXPECT_LE(largestRelativeError(context(), TransferFunction(peaks().points(), "t", Emission::PerLength), segments),
            1e-4);
}

// No absorption at all: what each segment sends is the mean of its ends times its length, to the last digits.
TEST_F(GpuTest, EmissionWithoutExtinctionIsMeanTimesLength) {
  const TransferFunction clear({{0, {1, 0, 3}, 0}, {1, {0, 2, 3}, 0}}, "clear", Emission::PerLength);
  std::vector<Segment> segments;
  for (const double length : {1e-9, 1e-3, 1.0, 1e6}) {
    for (const auto& [front, back] :
         {std::pair(0.0, 1.0), std::pair(1.0, 0.0), std::pair(0.5, 0.5), std::pair(0.2, 0.3)})
      segments.push_back({front, back, length});
  }
  const auto found = integrateOnDevice(context(), clear, segments);
  for (size_t i = 0; i < segments.size(); i++) {
    const double middle = 0.5 * (segments[i].front + segments[i].back);
    EXPECT_NEAR(static_cast<double>(found[i].x) / ((1 - middle) * segments[i].length), 1.0, 2e-6);
    EXPECT_NEAR(static_cast<double>(found[i].y) / (2 * middle * segments[i].length), 1.0, 2e-6);
    EXPECT_EQ(found[i].w, 0.0f);
  }
}

// A bright glow far behind an opaque layer still shows as much of itself as the layer lets through.
TEST_F(GpuTest, EmissionBehindAnOpaqueLayerKeepsItsDigits) {
  const TransferFunction transfer({{0, {}, 40}, {0.5, {}, 40}, {0.5, {1e6, 0, 0}, 0}, {1, {1e6, 0, 0}, 0}}, "t",
                                  Emission::PerLength);
  const auto found = integrateOnDevice(context(), transfer, {{0, 1, 1.0}});
  EXPECT_NEAR(static_cast<double>(found[0].x) / (0.5e6 * std::exp(-20.0)), 1.0, 3e-5);
}

TEST_F(GpuTest, IntegralWithManyControlPoints) {
  std::vector<ControlPoint> points;
  for (int i = 0; i < 1000; i++) points.push_back({i / 999.0, {i % 3 * 0.5, i % 5 * 0.25, i % 7 / 6.0}, i % 11 * 0.3});
  std::vector<Segment> segments;
  for (int i = 0; i < 50; i++) segments.push_back({i / 49.0, 1.0 - i / 49.0, 1.0});
  EXPECT_LE(largestError(context(), TransferFunction(points, "t"), segments), 5e-5);
}

}  // namespace
}  // namespace tetralux::render
