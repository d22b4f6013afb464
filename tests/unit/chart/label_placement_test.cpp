#include "chart/label_placement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tetralux::chart {
namespace {

constexpr Rect kArea{0, 0, 800, 400};
constexpr double kFont = 11, kRadius = 5;

TEST(PlaceLabels, NoLabelHidesAnotherOrAPoint) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<LabelRequest> requests;
  for (int i = 0; i < 25; i++)
    requests.push_back({300 + 200 * unit(random), 150 + 100 * unit(random), "label " + std::to_string(i), i % 7 == 0});
  const auto placed = placeLabels(requests, kArea, {}, kFont, kRadius);
  size_t count = 0;
  for (size_t i = 0; i < placed.size(); i++) {
    if (!placed[i]) continue;
    count++;
    EXPECT_TRUE(kArea.contains(placed[i]->rect));
    for (size_t k = 0; k < requests.size(); k++) {
      const Rect mark{requests[k].x - kRadius, requests[k].y - kRadius, 2 * kRadius, 2 * kRadius};
      EXPECT_FALSE(placed[i]->rect.overlaps(mark)) << i << " " << k;
      if (k != i && placed[k]) {
        EXPECT_FALSE(placed[i]->rect.overlaps(placed[k]->rect)) << i << " " << k;
      }
    }
  }
  EXPECT_EQ(count, requests.size());
}

TEST(PlaceLabels, ALabelKeepsClearOfLinesWhereItCan) {
  const Segment line{0, 200, 800, 200};
  const auto placed = placeLabels({{400, 200, "on the line", false}}, kArea, {line}, kFont, kRadius);
  ASSERT_TRUE(placed[0].has_value());
  EXPECT_FALSE(line.crosses(placed[0]->rect));
}

TEST(PlaceLabels, WhatHasNoRoomHasNoLabel) {
  const auto placed = placeLabels({{20, 10, "much longer than the area", false}}, {0, 0, 40, 20}, {}, kFont, kRadius);
  EXPECT_FALSE(placed[0].has_value());
}

TEST(SpreadApart, KeepsOrderAndGapsAndStaysWithin) {
  const std::vector<double> positions = {50, 51, 50.5, 10, 399, 398, 200};
  const std::vector<double> spread = spreadApart(positions, 15, 0, 400);
  for (size_t i = 0; i < positions.size(); i++) {
    EXPECT_GE(spread[i], 0.0);
    EXPECT_LE(spread[i], 400.0 + 1e-9);
    for (size_t k = 0; k < positions.size(); k++) {
      if (positions[i] < positions[k]) {
        EXPECT_LE(spread[i] + 15, spread[k] + 1e-9);
      }
    }
  }
  EXPECT_EQ(spread[6], 200);           // has room
  EXPECT_NEAR(spread[2], 50.5, 1e-9);  // a group keeps its middle
}

}  // namespace
}  // namespace tetralux::chart
