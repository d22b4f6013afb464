#include "cli/warm_up.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tetralux::cli {
namespace {

// Frames until the warm-up is over; frame i takes `frameMs(i)`, on the device and altogether.
template <typename FrameMs>
int framesOf(WarmUp warmUp, const FrameMs& frameMs) {
  double elapsed = 0.0;
  int frames = 0;
  for (; !warmUp.isOver(); frames++) {
    elapsed += frameMs(frames);
    warmUp.add(frameMs(frames), elapsed);
  }
  return frames;
}

TEST(WarmUp, WithoutATimeCountsFrames) {
  const auto falling = [](int frame) { return std::pow(0.5, frame); };
  EXPECT_EQ(framesOf(WarmUp(0, 0.0), falling), 0);
  EXPECT_EQ(framesOf(WarmUp(2, 0.0), falling), 2);
}

TEST(WarmUp, LastsForItsTime) {
  EXPECT_EQ(framesOf(WarmUp(2, 300.0), [](int) { return 10.0; }), 30);
  EXPECT_EQ(framesOf(WarmUp(50, 300.0), [](int) { return 10.0; }), 50);
}

TEST(WarmUp, WaitsUntilFramesStopBecomingFaster) {
  // From 100 to 10 ms by a tenth a frame: 22 frames; then two windows that are alike.
  const int frames = framesOf(WarmUp(2, 300.0), [](int frame) { return std::max(10.0, 100.0 * std::pow(0.9, frame)); });
  EXPECT_GE(frames, 27);
  EXPECT_LE(frames, 33);
}

TEST(WarmUp, IsNoLongerThanTenTimesItsTime) {
  const int frames = framesOf(WarmUp(0, 300.0), [](int frame) { return 1000.0 * std::pow(0.95, frame); });
  EXPECT_EQ(frames, 4);  // fewer than two windows, and 3.7 seconds
}

}  // namespace
}  // namespace tetralux::cli
