#include "gpu/buffer.h"

#include <gmock/gmock.h>

#include <numeric>

#include "gpu/image.h"
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

TEST_F(GpuTest, EmptyBufferIsAllowed) {
  const Buffer buffer = makeBuffer(context(), std::vector<float>{}, "test");
  EXPECT_EQ(buffer.sizeBytes(), 4u);
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
