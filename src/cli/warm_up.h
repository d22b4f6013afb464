// How many frames are drawn before those that are timed.
#pragma once

#include <cstdint>
#include <vector>

#include "gpu/devices.h"

namespace tetralux::cli {

// GPUs lower their clocks while nothing is drawn, and take a fraction of a second to raise them again. Processors do
// not wait for this: the work before has kept them busy.
double defaultWarmupMs(const gpu::DeviceInfo& device);

// A warm-up ends after a number of frames and a time, and where a time is asked for not before frames have stopped
// becoming faster, but after ten times that time at the latest.
class WarmUp {
 public:
  WarmUp(std::uint32_t leastFrames, double leastMs) : leastFrames_(leastFrames), leastMs_(leastMs) {}

  //   frameMs     what a frame took on the device
  //   elapsedMs   since the warm-up began
  void add(double frameMs, double elapsedMs);
  bool isOver() const;

 private:
  bool isFalling() const;

  std::uint32_t leastFrames_;
  double leastMs_;
  double elapsedMs_ = 0.0;
  std::vector<double> frameMs_;
};

}  // namespace tetralux::cli
