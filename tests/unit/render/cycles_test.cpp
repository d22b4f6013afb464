#include "render/order/cycles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "shared/limits.h"
#include "shared/pixel_lists.h"

namespace tetralux::render {
namespace {

using shared::KEY_OUTSIDE;
using shared::KEY_TRANSPARENT;

// What peeling leaves of a graph, all of whose relations are given as pairs: the second cell is in front of the first.
class Remains {
 public:
  explicit Remains(std::uint32_t cells)
      : waiting(cells, 0), neighbors(cells), heads(cells, shared::NO_NODE), keys(cells, 0) {
    for (auto& n : neighbors) n.fill(0xffffffffu);
  }

  // The first four fronts of a cell are those of its faces, more are relations across gaps.
  void add(std::uint32_t behind, std::uint32_t front) {
    waiting[front]++;
    for (std::uint32_t k = 0; k < 4; k++) {
      if (neighbors[behind][k] != 0xffffffffu) continue;
      neighbors[behind][k] = front;
      waiting[behind] |= 1u << (shared::WAIT_FRONT_SHIFT + k);
      return;
    }
    relations.push_back({front, heads[behind]});
    heads[behind] = static_cast<std::uint32_t>(relations.size() - 1);
    waiting[behind] |= shared::WAIT_RELATED;
  }

  CycleReport resolve(std::uint32_t levelCount = 0) {
    return resolveCycles({waiting, neighbors, heads, relations, levelCount}, keys);
  }

  std::uint32_t level(std::uint32_t cell) const { return keys[cell] & ~KEY_TRANSPARENT; }

  std::vector<std::uint32_t> waiting;
  std::vector<std::array<std::uint32_t, 4>> neighbors;
  std::vector<std::uint32_t> heads;
  std::vector<shared::Relation> relations;
  std::vector<std::uint32_t> keys;
};

TEST(Cycles, AChainBehindAndInFrontOfACycle) {
  Remains r(7);
  r.waiting[0] = shared::WAIT_PEELED;  // behind all, peeled on level 0
  r.add(1, 2);
  r.add(2, 3);
  r.add(3, 1);  // 1, 2, 3 in a cycle
  r.add(3, 4);
  r.add(4, 5);
  r.waiting[6] = shared::WAIT_ABSENT;
  r.keys[6] = KEY_OUTSIDE;
  r.keys[5] = KEY_TRANSPARENT;
  const CycleReport report = r.resolve(1);
  EXPECT_EQ(report.cyclicCells, 3u);
  EXPECT_EQ(report.apartCells, 3u);
  ASSERT_EQ(report.apart.size(), 1u);
  EXPECT_EQ(report.apart[0].first, 1u);
  EXPECT_EQ(report.apart[0].end, 4u);
  EXPECT_EQ(r.level(1), r.level(2));
  EXPECT_EQ(r.level(2), r.level(3));
  EXPECT_GT(r.level(1), r.level(0));
  EXPECT_GT(r.level(4), r.level(3));
  EXPECT_GT(r.level(5), r.level(4));
  EXPECT_EQ(r.keys[5] & KEY_TRANSPARENT, KEY_TRANSPARENT);
  EXPECT_EQ(r.keys[6], KEY_OUTSIDE);
  EXPECT_EQ(report.largestKey, r.level(5));
}

TEST(Cycles, OfTransparentCellsOnlyAreNotDrawn) {
  Remains r(2);
  r.add(0, 1);
  r.add(1, 0);
  r.keys = {KEY_TRANSPARENT, KEY_TRANSPARENT};
  const CycleReport report = r.resolve();
  EXPECT_EQ(report.cyclicCells, 2u);
  EXPECT_TRUE(report.apart.empty());
}

// Whatever the graph: a front cell has a larger key, or shares that of a cycle; spans are those keys' slots.
TEST(Cycles, KeysOfRandomGraphsAreAnOrder) {
  std::mt19937 random(5);
  for (int round = 0; round < 50; round++) {
    const std::uint32_t cells = 60;
    Remains r(cells);
    std::vector<std::array<std::uint32_t, 2>> edges;
    std::uniform_int_distribution<std::uint32_t> any(0, cells - 1);
    for (int i = 0; i < 20 + 3 * round; i++) {
      const std::uint32_t a = any(random);
      const std::uint32_t b = any(random);
      if (a == b) continue;
      r.add(a, b);
      edges.push_back({a, b});
    }
    for (std::uint32_t i = 0; i < cells; i += 5) r.keys[i] |= KEY_TRANSPARENT;
    const CycleReport report = r.resolve();
    std::vector<std::uint32_t> drawn;
    for (std::uint32_t i = 0; i < cells; i++) {
      if (r.keys[i] < KEY_TRANSPARENT) drawn.push_back(i);
    }
    std::stable_sort(drawn.begin(), drawn.end(), [&](auto a, auto b) { return r.keys[a] < r.keys[b]; });
    const auto isApart = [&](std::uint32_t cell) {
      const auto slot = static_cast<std::uint32_t>(std::find(drawn.begin(), drawn.end(), cell) - drawn.begin());
      return std::any_of(report.apart.begin(), report.apart.end(),
                         [&](const SlotSpan& s) { return slot >= s.first && slot < s.end; });
    };
    for (const auto& [behind, front] : edges) {
      EXPECT_LE(r.level(behind), r.level(front));
      if (r.level(behind) == r.level(front) && r.keys[behind] < KEY_TRANSPARENT) {
        EXPECT_TRUE(isApart(behind));
      }
    }
  }
}

// More cycles behind each other than are worth a step each.
TEST(Cycles, ManyBehindEachOtherShareSteps) {
  constexpr std::uint32_t kCycles = 1000;
  Remains r(2 * kCycles);
  for (std::uint32_t i = 0; i < kCycles; i++) {
    r.add(2 * i, 2 * i + 1);
    r.add(2 * i + 1, 2 * i);
    if (i + 1 < kCycles) r.add(2 * i, 2 * i + 2);
  }
  const CycleReport report = r.resolve();
  EXPECT_EQ(report.cyclicCells, 2 * kCycles);
  EXPECT_LE(report.apart.size(), 40u);
  std::uint32_t covered = 0;
  for (const SlotSpan& span : report.apart) covered += span.end - span.first;
  EXPECT_EQ(covered, 2 * kCycles);
}

}  // namespace
}  // namespace tetralux::render
