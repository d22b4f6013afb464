#include "mesh/orientation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "exact_sign.h"
#include "mesh/random.h"

namespace tetralux {
namespace {

using test::ExactDeterminant;
using test::exactOrientation;

using Points = std::array<glm::dvec3, 4>;

int signOf(const Points& p) { return orientationSign(p[0], p[1], p[2], p[3]); }

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double above(double x) { return std::nextafter(x, kInfinity); }
double below(double x) { return std::nextafter(x, -kInfinity); }

// The exact sign, but for what the header calls a plane.
void expectExactSign(const Points& p) {
  const ExactDeterminant exact = exactOrientation(p[0], p[1], p[2], p[3]);
  const double edges = glm::length(p[1] - p[0]) * glm::length(p[2] - p[0]) * glm::length(p[3] - p[0]);
  const int sign = signOf(p);
  if (std::abs(exact.value) >= 1e-30 * edges || exact.sign == 0) {
    EXPECT_EQ(sign, exact.sign) << exact.value << " of " << edges;
  } else {
    EXPECT_TRUE(sign == 0 || sign == exact.sign) << exact.value << " of " << edges;
  }
}

TEST(OrientationSign, IsPositiveWhenTheLastPointSeesTheOthersAnticlockwiseFromBehind) {
  EXPECT_EQ(orientationSign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orientationSign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), -1);
}

TEST(OrientationSign, IsZeroForRepeatedPointsAndPointsOnALine) {
  const glm::dvec3 a(0.1, 0.2, 0.3), b(0.7, -0.1, 1e-9), c(3, 4e5, 0.1);
  for (const Points& p : {Points{a, a, b, c}, {a, b, a, c}, {a, b, c, a}, {b, a, a, c}, {a, a, a, a}})
    EXPECT_EQ(signOf(p), 0);
  EXPECT_EQ(orientationSign({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, c), 0);
}

// All points have the same height to the last digit, so the plane is exact whatever the heights' decimals are.
TEST(OrientationSign, OneUlpOffALevelPlaneDecides) {
  for (const double height : {0.1, -0.3, 1e-300, 1e6 + 0.1, 123456.7}) {
    for (const double offset : {0.0, 0.1, -1e6, 1e6 + 0.7}) {
      const auto at = [&](double x, double y, double z) { return glm::dvec3(offset + x, offset + y, z); };
      const glm::dvec3 a = at(0.1, 0.2, height), b = at(0.8, 0.1, height), c = at(0.3, 0.9, height);
      EXPECT_EQ(orientationSign(a, b, c, at(0.4, 0.4, height)), 0);
      EXPECT_EQ(orientationSign(a, b, c, at(0.4, 0.4, above(height))), 1);
      EXPECT_EQ(orientationSign(a, b, c, at(0.4, 0.4, below(height))), -1);
    }
  }
}

// In decimals the points lie on x + y + z = 1; as doubles most of them are a rounding off it.
TEST(OrientationSign, IsExactForMultiplesOfATenthOnAnObliquePlane) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i <= 10; i++) {
    for (int j = 0; i + j <= 10; j++) points.push_back(0.1 * glm::dvec3(i, j, 10 - i - j));
  }
  int positive = 0, negative = 0, planes = 0;
  for (std::uint64_t i = 0; i < 3000; i++) {
    Points p;
    for (std::uint64_t k = 0; k < 4; k++) {
      const double index = randomUnit(1, 4 * i + k) * static_cast<double>(points.size());
      p[k] = points[static_cast<size_t>(index)];
    }
    expectExactSign(p);
    (signOf(p) > 0 ? positive : signOf(p) < 0 ? negative : planes)++;
  }
  EXPECT_GT(positive, 1000);
  EXPECT_GT(negative, 1000);
  EXPECT_GT(planes, 200);
}

TEST(OrientationSign, IsExactOneUlpAroundAnObliquePlane) {
  for (const double offset : {0.0, 1e6}) {
    for (std::uint64_t i = 0; i < 300; i++) {
      const auto unit = [&](std::uint64_t k) { return randomUnit(2, 12 * i + k); };
      Points p;
      for (std::uint64_t k = 0; k < 3; k++) p[k] = offset + glm::dvec3(unit(3 * k), unit(3 * k + 1), unit(3 * k + 2));
      p[3] = p[0] + unit(9) * (p[1] - p[0]) + unit(10) * (p[2] - p[0]);
      expectExactSign(p);
      for (int axis = 0; axis < 3; axis++) {
        for (const double direction : {kInfinity, -kInfinity}) {
          Points moved = p;
          moved[3][axis] = std::nextafter(p[3][axis], direction);
          expectExactSign(moved);
        }
      }
    }
  }
}

// Edges of very different lengths, whose differences of coordinates round.
TEST(OrientationSign, IsExactForNearlyFlatCellsOfAllScales) {
  for (std::uint64_t i = 0; i < 3000; i++) {
    std::uint64_t next = 20 * i;
    const auto unit = [&] { return randomUnit(3, next++); };
    const auto vector = [&] {
      const double scale = std::exp2(40.0 * unit() - 20.0);
      return scale * glm::dvec3(unit() - 0.5, unit() - 0.5, unit() - 0.5);
    };
    Points p;
    p[0] = vector();
    p[1] = p[0] + vector();
    p[2] = p[0] + vector();
    p[3] = p[0] + (2.0 * unit() - 1.0) * (p[1] - p[0]) + (2.0 * unit() - 1.0) * (p[2] - p[0]);
    expectExactSign(p);
  }
}

TEST(OrientationSign, ExchangingTwoPointsTurnsTheSign) {
  for (const double offset : {0.0, 1e6}) {
    for (std::uint64_t i = 0; i < 200; i++) {
      const auto unit = [&](std::uint64_t k) { return offset + 0.1 * std::floor(10.0 * randomUnit(4, 12 * i + k)); };
      Points p;
      for (std::uint64_t k = 0; k < 4; k++) p[k] = {unit(3 * k), unit(3 * k + 1), unit(3 * k + 2)};
      const int sign = signOf(p);
      std::array<size_t, 4> order{0, 1, 2, 3};
      do {
        int parity = 1;
        for (size_t j = 0; j < 4; j++) {
          for (size_t k = j + 1; k < 4; k++) parity = order[j] < order[k] ? parity : -parity;
        }
        EXPECT_EQ(signOf({p[order[0]], p[order[1]], p[order[2]], p[order[3]]}), parity * sign);
      } while (std::next_permutation(order.begin(), order.end()));
    }
  }
}

TEST(OrientationSign, DoesNotChangeWithThePlaceOfPointsOnAGrid) {
  for (std::uint64_t i = 0; i < 200; i++) {
    const auto whole = [&](std::uint64_t k) { return std::floor(4.0 * randomUnit(5, 12 * i + k)); };
    Points p, moved;
    for (std::uint64_t k = 0; k < 4; k++) {
      p[k] = {whole(3 * k), whole(3 * k + 1), whole(3 * k + 2)};
      moved[k] = p[k] + glm::dvec3(0x1p50, -0x1p50, 0x1p49);
    }
    EXPECT_EQ(signOf(moved), signOf(p));
  }
}

}  // namespace
}  // namespace tetralux
