#include "cli/warm_up.h"

#include <algorithm>

namespace tetralux::cli {
namespace {

constexpr double kGpuWarmupMs = 300.0;
constexpr double kLongest = 10.0;  // times the least
// Two windows of so many frames are compared by their fastest frame, which is the least disturbed; a fall of less than
// a fiftieth is noise.
constexpr size_t kWindow = 5;
constexpr double kFall = 0.98;

}  // namespace

double defaultWarmupMs(const gpu::DeviceInfo& device) { return device.isCpu ? 0.0 : kGpuWarmupMs; }

void WarmUp::add(double frameMs, double elapsedMs) {
  frameMs_.push_back(frameMs);
  elapsedMs_ = elapsedMs;
}

bool WarmUp::isFalling() const {
  if (frameMs_.size() < 2 * kWindow) return true;
  const auto end = frameMs_.end();
  const double before = *std::min_element(end - 2 * kWindow, end - kWindow);
  return *std::min_element(end - kWindow, end) < kFall * before;
}

bool WarmUp::isOver() const {
  if (frameMs_.size() < leastFrames_ || elapsedMs_ < leastMs_) return false;
  return leastMs_ <= 0.0 || elapsedMs_ >= kLongest * leastMs_ || !isFalling();
}

}  // namespace tetralux::cli
