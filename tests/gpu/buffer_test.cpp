#include "gpu/buffer.h"

#include <gmock/gmock.h>

#include <array>
#include <numeric>

#include "gpu/image.h"
#include "gpu/packed_tables.h"
#include "gpu/pieced_buffer.h"
#include "gpu_fixture.h"
#include "support/expect_error.h"

namespace tetralux::gpu {
namespace {

using test::errorOf;
using test::GpuTest;
using ::testing::HasSubstr;

TEST_F(GpuTest, BufferHoldsWhatIsUploaded) {
  std::vector<std::uint32_t> values(100003);
  std::iota(values.begin(), values.end(), 7u);
  const Buffer buffer = makeBuffer(context(), values, "test");
  EXPECT_EQ(downloadVector<std::uint32_t>(context(), buffer, values.size()), values);
  const std::uint32_t nine = 9;
  upload(context(), buffer, &nine, 4, 4 * 5000);
  EXPECT_EQ(downloadVector<std::uint32_t>(context(), buffer, values.size())[5000], 9u);
}

TEST_F(GpuTest, PiecesHoldAllElementsInOrder) {
  for (const std::uint64_t count : {0u, 1u, 4095u, 4096u, 4097u, 100003u}) {
    const PiecedBuffer buffer = makePiecedBuffer<std::uint32_t>(
        context(), count, 12, "test", [](std::span<std::uint32_t> numbers, std::uint64_t first) {
          std::iota(numbers.begin(), numbers.end(), static_cast<std::uint32_t>(first));
        });
    ASSERT_EQ(buffer.pieces().size(), std::max<std::uint64_t>((count + 4095) / 4096, 1));
    std::uint32_t next = 0;
    for (const Buffer& piece : buffer.pieces()) {
      const std::uint64_t here = std::min<std::uint64_t>(4096, count - next);
      for (const std::uint32_t number : downloadVector<std::uint32_t>(context(), piece, here))
        EXPECT_EQ(number, next++);
    }
    EXPECT_EQ(next, count);
  }
}

TEST_F(GpuTest, EmptyBufferIsAllowed) {
  const Buffer buffer = makeBuffer(context(), std::vector<float>{}, "test");
  EXPECT_EQ(buffer.sizeBytes(), 4u);
}

TEST_F(GpuTest, SizesOfTexelBuffersLookAlike) {
  for (std::uint64_t bytes = 4; bytes < (1u << 18); bytes += 4) {
    const std::uint64_t padded = paddedTexelBytes(bytes);
    ASSERT_GE(padded, bytes);
    ASSERT_LE(padded, bytes + 512);
    ASSERT_NE(padded >> 8 & 0xffu, 0u) << bytes;
    ASSERT_NE(padded & (padded - 1), 0u) << bytes;
  }
}

TEST_F(GpuTest, PackedTablesAreReplacedInPlace) {
  const std::vector<std::uint32_t> first(100, 7);
  const std::vector<std::uint32_t> second(33, 8);
  PackedTables tables;
  TexelView a;
  TexelView b;
  const auto set = [&](const std::vector<std::uint32_t>& x, const std::vector<std::uint32_t>& y) {
    const std::array<TableView, 2> views = {
        {{&a, VK_FORMAT_R32_UINT, bytesOf(x)}, {&b, VK_FORMAT_R32_UINT, bytesOf(y)}}};
    tables.set(context(), views, "test");
    EXPECT_NE(a.get(), VK_NULL_HANDLE);
    EXPECT_NE(b.get(), VK_NULL_HANDLE);
    return tables.sizeBytes();
  };
  EXPECT_EQ(set(first, second), 512u + 256u);
  EXPECT_EQ(set(second, first), 512u + 256u);
  EXPECT_EQ(set(second, second), 512u + 256u) << "less needs no other buffer";
  EXPECT_EQ(set(first, first), 1024u);
}

TEST_F(GpuTest, BufferBeyondTheDeviceIsOutOfMemory) {
  EXPECT_THAT(errorOf(ErrorCode::Device,
                      [&] {
                        // Where the device states no limit below it, this is beyond any memory.
                        Buffer(context(),
                               std::max<std::uint64_t>(context().info().largestAllocationBytes, 1ull << 40) + 4,
                               MemoryKind::Device, "giant");
                      }),
              HasSubstr("out of memory"));
  gpu::downloadVector<int>(context(), Buffer(context(), 4, MemoryKind::Device, "after"), 1);
}

TEST_F(GpuTest, ImageBeyondTheDeviceIsNamed) {
  const std::uint32_t side = context().info().largestImageSide + 1;
  EXPECT_THAT(
      errorOf(ErrorCode::Device, [&] { AttachmentImage(context(), side, 1, VK_FORMAT_R32G32B32A32_SFLOAT, "test"); }),
      HasSubstr("allows " + std::to_string(side - 1) + " a side"));
}

}  // namespace
}  // namespace tetralux::gpu
