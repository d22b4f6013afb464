#include "mesh/delaunay_predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "mesh/delaunay_order.h"
#include "mesh/random.h"
#include "mesh_checks.h"

namespace tetralux {
namespace {

test::IntPoint asInts(const GridPoint& p) { return {p.x, p.y, p.z}; }

std::vector<GridPoint> cubeCorners(std::int32_t edge) {
  std::vector<GridPoint> corners;
  for (int i = 0; i < 8; i++) corners.push_back({i & 1 ? edge : 0, i & 2 ? edge : 0, i & 4 ? edge : 0});
  return corners;
}

std::vector<GridPoint> randomGridPoints(size_t count, std::int32_t size, std::uint64_t seed) {
  std::vector<GridPoint> points(count);
  const auto coordinate = [&](std::uint64_t index) {
    return static_cast<std::int32_t>(randomUnit(seed, index) * (size + 1));
  };
  for (size_t i = 0; i < count; i++) points[i] = {coordinate(3 * i), coordinate(3 * i + 1), coordinate(3 * i + 2)};
  return points;
}

TEST(Predicates, OrientationIsExactAtTheEndsOfTheGrid) {
  const GridPoint a{0, 0, 0}, b{kGridSize, 0, 0}, c{0, kGridSize, 0}, d{0, 0, kGridSize};
  EXPECT_EQ(orient3d(a, b, c, d), std::int64_t{1} << 60);
  EXPECT_EQ(orient3d(b, a, c, d), -(std::int64_t{1} << 60));
  const GridPoint opposite{kGridSize, kGridSize, kGridSize};
  EXPECT_EQ(orient3d(opposite, b, c, d), -(std::int64_t{2} << 60));
}

TEST(Predicates, OrientationSeesOneStepOverTheWholeGrid) {
  const GridPoint a{0, 0, 0}, b{kGridSize, kGridSize - 1, 0}, c{kGridSize - 1, kGridSize - 2, 0};
  EXPECT_EQ(orient3d(a, b, c, {5, 5, 1}), -1);
  EXPECT_EQ(orient3d(a, b, c, {5, 5, 0}), 0);
}

TEST(Predicates, AgreeWithTheCircumcentreOnRandomPoints) {
  for (const std::int32_t size : {4, 100, kGridSize}) {
    const std::vector<GridPoint> p = randomGridPoints(5000, size, 1);
    size_t ties = 0;
    for (size_t i = 0; i + 5 <= p.size(); i += 5) {
      std::array<GridPoint, 4> cell{p[i], p[i + 1], p[i + 2], p[i + 3]};
      const std::int64_t orientation = orient3d(cell[0], cell[1], cell[2], cell[3]);
      ASSERT_TRUE(orientation == test::volume6(asInts(p[i]), asInts(p[i + 1]), asInts(p[i + 2]), asInts(p[i + 3])));
      if (orientation == 0) continue;
      if (orientation < 0) std::swap(cell[0], cell[1]);
      const test::Int128 inside =
          test::insideSphere({asInts(cell[0]), asInts(cell[1]), asInts(cell[2]), asInts(cell[3])}, asInts(p[i + 4]));
      ties += inside == 0;
      if (inside != 0) {
        ASSERT_EQ(inCircumsphere(cell[0], cell[1], cell[2], cell[3], p[i + 4]), inside > 0);
      }
    }
    EXPECT_EQ(ties > 0, size == 4);
  }
}

// Lifted points in general position: of five points, whether the fifth lies inside the first four's sphere settles for
// every other choice of a cell among the five. p_i is inside the sphere of the rest, taken positive, exactly if the
// signed test, one antisymmetric function of the five, has one sign.
TEST(Predicates, TiesAreAntisymmetricInAllFivePoints) {
  const std::vector<GridPoint> corners = cubeCorners(kGridSize);
  const auto signedTest = [](const std::array<GridPoint, 5>& q) {
    const std::int64_t orientation = orient3d(q[0], q[1], q[2], q[3]);
    if (orientation == 0) return 0;
    return orientation > 0 ? (inCircumsphere(q[0], q[1], q[2], q[3], q[4]) ? 1 : -1)
                           : (inCircumsphere(q[1], q[0], q[2], q[3], q[4]) ? -1 : 1);
  };
  size_t compared = 0;
  std::array<int, 8> choice{1, 1, 1, 1, 1, 0, 0, 0};
  do {
    std::array<size_t, 5> chosen;
    for (size_t i = 0, n = 0; i < 8; i++) {
      if (choice[i]) chosen[n++] = i;
    }
    int expected = 0;
    do {
      int sign = 1;
      for (size_t i = 0; i < 5; i++) {
        for (size_t j = i + 1; j < 5; j++) sign *= chosen[i] < chosen[j] ? 1 : -1;
      }
      std::array<GridPoint, 5> q;
      for (size_t i = 0; i < 5; i++) q[i] = corners[chosen[i]];
      const int result = signedTest(q);
      if (result == 0) continue;  // the first four are coplanar
      if (expected == 0) expected = sign * result;
      ASSERT_EQ(sign * result, expected);
      compared++;
    } while (std::next_permutation(chosen.begin(), chosen.end()));
  } while (std::prev_permutation(choice.begin(), choice.end()));
  EXPECT_GT(compared, 5000u);
}

TEST(HilbertIndex, NeighboursOnTheCurveAreNeighboursInSpace) {
  constexpr std::int32_t kEdge = 16;
  std::vector<GridPoint> atIndex(kEdge * kEdge * kEdge);
  for (std::int32_t x = 0; x < kEdge; x++) {
    for (std::int32_t y = 0; y < kEdge; y++) {
      for (std::int32_t z = 0; z < kEdge; z++) atIndex.at(hilbertIndex({x, y, z})) = {x, y, z};
    }
  }
  EXPECT_EQ(atIndex[0], GridPoint{});
  for (size_t i = 1; i < atIndex.size(); i++) {
    const GridPoint& a = atIndex[i - 1];
    const GridPoint& b = atIndex[i];
    ASSERT_EQ(std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z), 1) << i;
  }
}

TEST(HilbertIndex, HoldsTheLastPlaceOfTheGrid) {
  EXPECT_LT(hilbertIndex({kGridSize, kGridSize, kGridSize}), std::uint64_t{1} << 63);
  EXPECT_NE(hilbertIndex({kGridSize, 0, 0}), hilbertIndex({kGridSize - 1, 0, 0}));
}

TEST(InsertionOrder, HasEveryPlaceOnceByItsFirstPoint) {
  const std::vector<GridPoint> points = randomGridPoints(3000, 9, 7);  // 1000 places
  const std::vector<std::uint32_t> order = insertionOrder(points);
  for (size_t i = 0; i < points.size(); i++) {
    const bool first = std::find(points.begin(), points.end(), points[i]) == points.begin() + static_cast<long>(i);
    ASSERT_EQ(std::count(order.begin(), order.end(), i), first ? 1 : 0) << i;
  }
}

}  // namespace
}  // namespace tetralux
