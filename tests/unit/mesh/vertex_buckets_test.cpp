#include "mesh/vertex_buckets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "mesh/random.h"

namespace tetralux {
namespace {

TEST(SortedVertices, AreAscendingWhateverTheOrderWas) {
  for (const CellVertices& ascending :
       {CellVertices{2, 5, 7, 9}, {1, 1, 4, 8}, {3, 6, 6, 6}, {0, 0, 0xffffffff, 0xffffffff}}) {
    CellVertices v = ascending;
    do {
      EXPECT_EQ(sortedVertices(v), ascending);
    } while (std::next_permutation(v.begin(), v.end()));
  }
}

TEST(SortedVertices, ShowARepeatedVertex) {
  EXPECT_FALSE(hasRepeatedVertex({0, 1, 2, 3}));
  EXPECT_TRUE(hasRepeatedVertex({0, 0, 2, 3}));
  EXPECT_TRUE(hasRepeatedVertex({0, 2, 2, 3}));
  EXPECT_TRUE(hasRepeatedVertex({0, 1, 3, 3}));
}

// Keys of a cell are its index, once for each of a few random points; some points have none, one has very many.
TEST(VertexBuckets, HoldEveryKeyOnceAtItsPoint) {
  constexpr std::uint32_t kPoints = 700;
  for (const size_t cells : {size_t{0}, size_t{1}, size_t{1000}, 5 * VertexBuckets<std::uint32_t>::kCellsAtOnce + 3}) {
    std::multimap<std::uint32_t, std::uint32_t> expected;
    const auto forEachKey = [](size_t cell, const auto& emit) {
      emit(std::uint32_t{13}, static_cast<std::uint32_t>(cell));
      for (std::uint64_t i = 0; i < cell % 4; i++)
        emit(static_cast<std::uint32_t>(500.0 * randomUnit(1, 4 * cell + i)), static_cast<std::uint32_t>(cell));
    };
    for (size_t cell = 0; cell < cells; cell++)
      forEachKey(cell, [&](std::uint32_t point, std::uint32_t key) { expected.emplace(point, key); });

    auto buckets = VertexBuckets<std::uint32_t>::dealOut(cells, kPoints, forEachKey);
    EXPECT_EQ(buckets.keys.size(), expected.size());
    for (std::uint32_t point = 0; point < kPoints; point++) {
      const auto bucket = buckets.of(point);
      std::vector<std::uint32_t> keys(bucket.begin(), bucket.end());
      std::sort(keys.begin(), keys.end());
      std::vector<std::uint32_t> expectedKeys;
      for (auto [at, end] = expected.equal_range(point); at != end; ++at) expectedKeys.push_back(at->second);
      std::sort(expectedKeys.begin(), expectedKeys.end());
      ASSERT_EQ(keys, expectedKeys) << point;
    }
  }
}

}  // namespace
}  // namespace tetralux
