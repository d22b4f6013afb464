#include "render/sort_pass.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <ostream>
#include <random>

#include "gpu_fixture.h"
#include "shared/limits.h"
#include "shared/sort.h"

namespace tetralux::render {
namespace {

using shared::KEY_TRANSPARENT;

struct SortCase {
  SortVariant variant;
  bool wideAddressing;

  friend std::ostream& operator<<(std::ostream& out, const SortCase& c) {
    return out << (c.variant == SortVariant::Tiles ? "tiles" : "chunks") << (c.wideAddressing ? ", wide" : "");
  }
};

class SortPassTest : public test::GpuTest, public ::testing::WithParamInterface<SortCase> {
 protected:
  // What the sort must give: indices of the kept keys by the range's bits of the key, ties by index.
  static std::vector<std::uint32_t> expectedOrder(const std::vector<std::uint32_t>& keys, SortRange range = {0, 31}) {
    const auto bits = [&](std::uint32_t i) { return keys[i] >> range.firstBit & ((1u << range.bitCount) - 1); };
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < keys.size(); i++) {
      if (keys[i] < KEY_TRANSPARENT) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return bits(a) < bits(b); });
    return order;
  }

  std::vector<std::uint32_t> sortOnDevice(const std::vector<std::uint32_t>& keys, SortRange range) {
    if (!pass_) pass_.emplace(context(), GetParam().variant);
    SortStorage storage(context(), static_cast<std::uint32_t>(keys.size()), GetParam().variant);
    gpu::upload(context(), storage.keys(), keys.data(), keys.size() * sizeof keys[0]);
    test::runCommands(context(), [&](gpu::CommandBuffer& commands) {
      pass_->record(commands, storage, range, GetParam().wideAddressing);
    });
    const std::uint32_t kept = gpu::downloadVector<std::uint32_t>(context(), storage.kept(), 1)[0];
    EXPECT_LE(kept, keys.size());
    return gpu::downloadVector<std::uint32_t>(context(), storage.order(range), std::min<size_t>(kept, keys.size()));
  }

 private:
  std::optional<SortPass> pass_;
};

std::vector<std::uint32_t> randomKeys(size_t count, std::uint32_t bits, std::mt19937& random) {
  std::vector<std::uint32_t> keys(count);
  for (std::uint32_t& key : keys) key = static_cast<std::uint32_t>(random() & ((1ull << bits) - 1));
  return keys;
}

TEST_P(SortPassTest, SortsSizesThroughTwoPartitionsAndOne) {
  std::mt19937 random(1);
  const std::uint32_t partition =
      GetParam().variant == SortVariant::Tiles ? shared::SORT_TILE_KEYS : shared::SORT_LEAST_CHUNKS;
  // Every size near whole partitions and subgroups of them, every seventh between; the path by addresses shares all but
  // loads and stores.
  const std::uint32_t near = GetParam().wideAddressing ? 8 : 130;
  const auto isNear = [&](std::uint32_t size) {
    return size % partition < near || partition - size % partition < near;
  };
  for (std::uint32_t size = 0; size <= 2 * partition + 1; size += isNear(size) ? 1 : 7) {
    const auto keys = randomKeys(size, 8, random);
    ASSERT_EQ(sortOnDevice(keys, {0, 8}), expectedOrder(keys)) << size;
  }
}

TEST_P(SortPassTest, SortsManyKeysOfManyBits) {
  std::mt19937 random(2);
  for (const std::uint32_t bits : {1u, 8u, 9u, 16u, 24u, 31u}) {
    const auto keys = randomKeys(100003, bits, random);
    EXPECT_EQ(sortOnDevice(keys, {0, bits}), expectedOrder(keys)) << bits;
  }
}

// Longer than 65535 keys for each of the least number of runs: the software device ends loops there.
TEST_P(SortPassTest, SortsMillionsOfKeys) {
  if (GetParam().wideAddressing) GTEST_SKIP() << "differs from the other path in loads and stores only";
  std::mt19937 random(6);
  const auto keys = randomKeys(65536ull * shared::SORT_LEAST_CHUNKS + 12345, 8, random);
  EXPECT_TRUE(sortOnDevice(keys, {0, 8}) == expectedOrder(keys));
}

TEST_P(SortPassTest, KeepsOrderAmongEqualKeysAndTurnsReversedOnes) {
  std::vector<std::uint32_t> keys(10007, 0x123456);
  EXPECT_EQ(sortOnDevice(keys, {0, 24}), expectedOrder(keys));
  std::iota(keys.rbegin(), keys.rend(), 0u);
  EXPECT_EQ(sortOnDevice(keys, {0, 24}), expectedOrder(keys));
  std::mt19937 random(3);
  for (std::uint32_t& key : keys) key = static_cast<std::uint32_t>(random() % 3) << 20;
  EXPECT_EQ(sortOnDevice(keys, {0, 24}), expectedOrder(keys));
}

TEST_P(SortPassTest, DropsCulledKeys) {
  std::mt19937 random(4);
  for (const std::uint32_t share : {1u, 2u, 10u}) {
    auto keys = randomKeys(20011, 24, random);
    for (std::uint32_t& key : keys) {
      if (random() % share == 0) key = random() % 2 == 0 ? shared::KEY_OUTSIDE : key | KEY_TRANSPARENT;
    }
    EXPECT_EQ(sortOnDevice(keys, {0, 24}), expectedOrder(keys)) << "one in " << share;
  }
}

// Floating-point keys of all kinds, in the integer form that orders positive ones.
TEST_P(SortPassTest, OrdersDenormalAndInfiniteDistances) {
  std::vector<std::uint32_t> keys;
  for (const float f : {0.0f, 1e-45f, 1e-40f, 1e-38f, 1.0f, 3e38f, INFINITY}) {
    for (int i = 0; i < 300; i++) keys.push_back(std::bit_cast<std::uint32_t>(f));
  }
  std::shuffle(keys.begin(), keys.end(), std::mt19937(5));
  EXPECT_EQ(sortOnDevice(keys, {0, 31}), expectedOrder(keys));
}

// Keys that agree in the range keep the order of their indices, whatever the bits below it say.
TEST_P(SortPassTest, LooksAtItsRangeOfBitsOnly) {
  std::mt19937 random(7);
  const auto keys = randomKeys(20011, 24, random);
  for (const SortRange range : {SortRange{16, 8}, SortRange{24, 7}, SortRange{8, 16}, SortRange{3, 21}})
    EXPECT_EQ(sortOnDevice(keys, range), expectedOrder(keys, range)) << range.firstBit << " " << range.bitCount;
}

INSTANTIATE_TEST_SUITE_P(Variants, SortPassTest,
                         ::testing::Values(SortCase{SortVariant::Tiles, false}, SortCase{SortVariant::Chunks, false},
                                           SortCase{SortVariant::Tiles, true}, SortCase{SortVariant::Chunks, true}),
                         [](const auto& sortCase) {
                           return std::string(sortCase.param.variant == SortVariant::Tiles ? "tiles" : "chunks") +
                                  (sortCase.param.wideAddressing ? "_wide" : "");
                         });

}  // namespace
}  // namespace tetralux::render
