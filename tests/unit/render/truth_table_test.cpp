#include "render/truth_table.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

namespace tetralux::render {
namespace {

using Point = std::array<int, 2>;

long cross(const Point& o, const Point& a, const Point& b) {
  return static_cast<long>(a[0] - o[0]) * (b[1] - o[1]) - static_cast<long>(a[1] - o[1]) * (b[0] - o[0]);
}

// Twice the signed areas of the four outward faces; they sum to zero.
std::array<long, 4> faceAreas(const std::array<Point, 4>& p) {
  return {cross(p[1], p[2], p[3]), -cross(p[0], p[2], p[3]), cross(p[0], p[1], p[3]), -cross(p[0], p[1], p[2])};
}

std::uint32_t tableIndex(const std::array<long, 4>& areas) {
  std::uint32_t index = 0;
  for (const long a : areas) index = index * 3 + (a > 0 ? 2u : a < 0 ? 0u : 1u);
  return index;
}

TEST(TruthTable, HasTheCasesOfThePaper) {
  std::map<std::uint32_t, int> count;
  for (const std::uint32_t entry : makeTruthTable()) count[shared::truthClass(entry)]++;
  EXPECT_EQ(count[1], 8);
  EXPECT_EQ(count[2], 6);
  EXPECT_EQ(count[3], 24);
  EXPECT_EQ(count[4], 12);
  EXPECT_EQ(count[0], 31);
}

// Every entry is met by projections on a small grid, so that degenerate ones occur exactly; the fan must cover the
// projection once and its centre must be a point of both the front and the back.
TEST(TruthTable, FansCoverTheProjectionForAllSigns) {
  const auto table = makeTruthTable();
  std::mt19937 random(1);
  std::uniform_int_distribution<int> coordinate(0, 4);
  std::set<std::uint32_t> seen;
  for (int i = 0; i < 200000; i++) {
    std::array<Point, 4> p;
    for (Point& q : p) q = {coordinate(random), coordinate(random)};
    const auto areas = faceAreas(p);
    ASSERT_EQ(areas[0] + areas[1] + areas[2] + areas[3], 0);
    const std::uint32_t index = tableIndex(areas);
    const std::uint32_t entry = table[index];
    long positive = 0;
    for (const long a : areas) positive += std::max(a, 0l);
    if (positive == 0) {
      EXPECT_EQ(shared::truthTriangles(entry), 0u);
      continue;
    }
    seen.insert(index);
    ASSERT_NE(shared::truthClass(entry), 0u);

    // The centre times the sum of the positive areas, so that integers stay exact.
    std::array<long, 2> centre = {0, 0};
    for (size_t v = 0; v < 4; v++) {
      for (size_t axis = 0; axis < 2; axis++) centre[axis] += std::max(areas[v], 0l) * p[v][axis];
    }
    const std::uint32_t centreVertex = shared::truthCentre(entry);
    if (centreVertex < 4) {
      for (size_t axis = 0; axis < 2; axis++) ASSERT_EQ(centre[axis], positive * p[centreVertex][axis]);
    }
    long covered = 0;
    std::uint32_t triangles = 0;
    int sense = 0;
    for (std::uint32_t k = 0; k < 4; k++) {
      const Point& a = p[shared::truthRing(entry, k)];
      const Point& b = p[shared::truthRing(entry, (k + 1) % 4)];
      const long area = (positive * a[0] - centre[0]) * (positive * b[1] - centre[1]) -
                        (positive * a[1] - centre[1]) * (positive * b[0] - centre[0]);
      if (area == 0) continue;
      triangles++;
      if (sense == 0) sense = area > 0 ? 1 : -1;
      EXPECT_EQ(area > 0 ? 1 : -1, sense) << "a fan that folds over";
      covered += std::abs(area);
    }
    EXPECT_EQ(triangles, shared::truthTriangles(entry));
    EXPECT_EQ(covered, positive * positive * positive) << "areas times the square of the centre's denominator";
  }
  EXPECT_EQ(seen.size(), 50u);
}

}  // namespace
}  // namespace tetralux::render
