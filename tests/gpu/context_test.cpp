#include <gmock/gmock.h>

#include "gpu_fixture.h"
#include "support/expect_error.h"

namespace tetralux::gpu {
namespace {

using test::errorOf;
using test::GpuTest;
using ::testing::HasSubstr;

TEST_F(GpuTest, DevicesAreListedWithWhatTheyLack) {
  const auto devices = listDevices();
  ASSERT_FALSE(devices.empty());
  const DeviceInfo& own = context().info();
  const DeviceInfo& same = devices.at(own.index);
  EXPECT_EQ(same.name, own.name);
  EXPECT_TRUE(same.missing.empty());
  EXPECT_GE(same.largestStorageRangeBytes, 128u << 20);
  EXPECT_GE(same.subgroupSize, 1u);
}

TEST_F(GpuTest, DeviceIsChosenByIndexOrPartOfItsName) {
  const DeviceInfo& own = context().info();
  EXPECT_EQ(Context({std::to_string(own.index), false}).info().name, own.name);
  std::string part = own.name.substr(1, 5);
  for (char& c : part) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  EXPECT_EQ(Context({part, false}).info().name, own.name);
}

TEST_F(GpuTest, UnknownDeviceListsTheOthers) {
  EXPECT_THAT(errorOf(ErrorCode::Device,
                      [] {
                        Context({"no such device", false});
                      }),
              HasSubstr("no device matches 'no such device', expected one of 0: "));
  EXPECT_THAT(errorOf(ErrorCode::Device, [] { Context({"99", false}); }), HasSubstr("no device matches '99'"));
}

TEST(GroupCount, CoversAllThreadsWithinWhatEveryDeviceAllows) {
  for (const std::uint64_t threads : {0ull, 1ull, 64ull, 65ull, 65535ull * 64, 65535ull * 64 + 1, 5000000000ull}) {
    const GroupCount groups = groupCount(threads, 64);
    EXPECT_LE(groups.x, 65535u);
    EXPECT_GE(std::uint64_t{groups.x} * groups.y * 64, threads);
    if (threads > 0) {
      EXPECT_LT(std::uint64_t{groups.x} * groups.y * 64, threads + 64ull * (groups.y + 1));
    }
  }
}

}  // namespace
}  // namespace tetralux::gpu
