#include "chart/pareto.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tetralux::chart {
namespace {

bool dominates(const Cost& a, const Cost& b) { return a.x <= b.x && a.y <= b.y && (a.x < b.x || a.y < b.y); }

TEST(ParetoFront, NothingDominatesAMemberAndAMemberDominatesTheRest) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> value(0, 12);  // few values: many are equal
  for (int round = 0; round < 300; round++) {
    std::vector<Cost> costs;
    for (int i = 0; i < 20; i++) costs.push_back({double(value(random)), double(value(random))});
    const std::vector<size_t> front = paretoFront(costs);
    ASSERT_FALSE(front.empty());
    for (size_t i = 0; i < costs.size(); i++) {
      const bool isMember = std::find(front.begin(), front.end(), i) != front.end();
      bool isCovered = false;  // dominated by a member, or equal to one
      for (const size_t m : front) {
        if (isMember) {
          EXPECT_FALSE(dominates(costs[m], costs[i]));
        }
        isCovered =
            isCovered || dominates(costs[m], costs[i]) || (costs[m].x == costs[i].x && costs[m].y == costs[i].y);
      }
      EXPECT_TRUE(isCovered);
    }
    for (size_t k = 1; k < front.size(); k++) {
      EXPECT_LT(costs[front[k - 1]].x, costs[front[k]].x);
      EXPECT_GT(costs[front[k - 1]].y, costs[front[k]].y);
    }
  }
}

TEST(ParetoFront, OfEqualCostsTheFirstIsKept) { EXPECT_EQ(paretoFront({{1, 1}, {1, 1}}), std::vector<size_t>{0}); }

TEST(ParetoFront, WhatIsNotFiniteIsNoMember) {
  EXPECT_EQ(paretoFront({{std::nan(""), 0.0}, {2.0, 2.0}, {1.0, std::nan("")}, {INFINITY, 0.0}}),
            std::vector<size_t>{1});
  EXPECT_TRUE(paretoFront({}).empty());
}

}  // namespace
}  // namespace tetralux::chart
