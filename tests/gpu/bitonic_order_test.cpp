// The bitonic sort against std::stable_sort, and its pictures against the radix sort's.
#include "render/order/bitonic_order.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include "gpu_fixture.h"
#include "image/metrics.h"
#include "mesh/generate.h"
#include "render/renderer.h"
#include "shared/bitonic.h"
#include "shared/limits.h"

namespace tetralux::render {
namespace {

using shared::BITONIC_BLOCK;
using shared::KEY_TRANSPARENT;

using Keys = std::vector<std::uint32_t>;

// Indices of the kept keys by key, ties by index.
Keys expectedOrder(const Keys& keys) {
  Keys order;
  for (std::uint32_t i = 0; i < keys.size(); i++) {
    if (keys[i] < KEY_TRANSPARENT) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return keys[a] < keys[b]; });
  return order;
}

Keys randomKeys(size_t count, std::uint32_t bits, std::uint32_t seed) {
  std::mt19937 random(seed);
  Keys keys(count);
  for (std::uint32_t& key : keys) key = static_cast<std::uint32_t>(random() & ((1ull << bits) - 1));
  return keys;
}

// The parameter: whether buffers are reached by address.
class BitonicOrderTest : public test::GpuTest, public ::testing::WithParamInterface<bool> {
 protected:
  Keys sortOnDevice(const Keys& keys) {
    if (!pass_) pass_ = std::make_unique<BitonicPass>(context());
    const auto count = static_cast<std::uint32_t>(keys.size());
    const SortStorage sort(context(), count, SortVariant::Chunks);
    const BitonicStorage storage(context(), count);
    gpu::upload(context(), sort.keys(), keys.data(), keys.size() * sizeof keys[0]);
    test::runCommands(context(),
                      [&](gpu::CommandBuffer& commands) { pass_->record(commands, sort, storage, GetParam()); });
    EXPECT_EQ(gpu::downloadVector<std::uint32_t>(context(), sort.keys(), keys.size()), keys) << "keys stay";
    const std::uint32_t kept = gpu::downloadVector<std::uint32_t>(context(), sort.kept(), 1)[0];
    EXPECT_LE(kept, keys.size());
    return gpu::downloadVector<std::uint32_t>(context(), sort.order(BitonicPass::kResult),
                                              std::min<size_t>(kept, keys.size()));
  }

 private:
  std::unique_ptr<BitonicPass> pass_;
};

TEST_P(BitonicOrderTest, EqualsAStableSortForEverySizeOfInterest) {
  std::vector<size_t> sizes = {0, 1, 2, 3, 63, 64, 65, 1000, 3 * BITONIC_BLOCK + 1, 100000};
  for (size_t power = 4; power <= 16 * BITONIC_BLOCK; power *= 2) {
    for (const size_t size : {power - 1, power, power + 1}) sizes.push_back(size);
  }
  for (const size_t size : sizes) {
    const Keys keys = randomKeys(size, 24, 1);
    ASSERT_EQ(sortOnDevice(keys), expectedOrder(keys)) << size;
  }
}

TEST_P(BitonicOrderTest, KeepsOrderAmongEqualKeysAndTurnsReversedOnes) {
  Keys keys(3 * BITONIC_BLOCK + 17, 0x123456);
  EXPECT_EQ(sortOnDevice(keys), expectedOrder(keys));
  std::iota(keys.rbegin(), keys.rend(), 0u);
  EXPECT_EQ(sortOnDevice(keys), expectedOrder(keys));
  keys = randomKeys(keys.size(), 2, 2);
  EXPECT_EQ(sortOnDevice(keys), expectedOrder(keys));
}

TEST_P(BitonicOrderTest, LeavesOutTransparentAndOutsideCells) {
  for (const std::uint32_t share : {1u, 2u, 10u}) {
    std::mt19937 random(share);
    for (const size_t size : {size_t{1}, size_t{100}, size_t{5 * BITONIC_BLOCK + 3}}) {
      Keys keys = randomKeys(size, 24, 3);
      for (std::uint32_t& key : keys) {
        if (random() % share == 0) key = random() % 2 == 0 ? shared::KEY_OUTSIDE : key | KEY_TRANSPARENT;
      }
      EXPECT_EQ(sortOnDevice(keys), expectedOrder(keys)) << size << ", one in " << share;
    }
  }
}

// The largest key that takes part is less than those that do not.
TEST_P(BitonicOrderTest, ComparesAll31Bits) {
  Keys keys = randomKeys(10007, 31, 4);
  keys[5] = KEY_TRANSPARENT - 1;
  keys[6] = 0;
  EXPECT_EQ(sortOnDevice(keys), expectedOrder(keys));
}

TEST_P(BitonicOrderTest, DrawsAndChecksWhatTheRadixSortDoes) {
  const TetMesh mesh = randomDelaunay(2000, 5);
  const TransferFunction transfer({{0, {1, 0.5, 0.2}, 0}, {0.6, {0.3, 0.9, 0.2}, 4}, {1, {0.1, 0.2, 0.9}, 1}}, "test");
  Camera camera;
  camera.eye = {2.1, -1.7, 1.3};
  camera.center = {0.5, 0.5, 0.5};
  camera.fovyDegrees = 40;
  const ImageSize size{120, 90};
  Image images[2];
  OrderReport reports[2];
  for (const Order order : {Order::Radix, Order::Bitonic}) {
    RendererOptions options;
    options.order = order;
    options.checkOrder = true;
    options.forceWideAddressing = GetParam();
    Renderer renderer(context(), mesh, scalarField(mesh, "", "test"), options);
    renderer.setTransferFunction(transfer);
    const size_t i = order == Order::Bitonic;
    reports[i] = renderer.draw(camera, size).order;
    images[i] = renderer.readImage();
    EXPECT_EQ(reports[i].order, order);
  }
  EXPECT_EQ(compareImages(images[0], images[1]).max, 0.0);
  EXPECT_GT(reports[1].faces, 10000u);
  EXPECT_EQ(reports[0].faces, reports[1].faces);
  EXPECT_EQ(reports[0].misordered, reports[1].misordered);
}

INSTANTIATE_TEST_SUITE_P(Addressing, BitonicOrderTest, ::testing::Values(false, true),
                         [](const auto& addressing) { return addressing.param ? "wide" : "descriptors"; });

}  // namespace
}  // namespace tetralux::render
