#include "base/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace tetralux {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

std::atomic<bool> progressEnabled{true};

constexpr milliseconds kFirstDraw{500};
constexpr milliseconds kTerminalInterval{100};
constexpr milliseconds kLogInterval{10000};

}  // namespace

void setProgressEnabled(bool enabled) { progressEnabled = enabled; }

Progress::Progress(std::string label, size_t total)
    : label_(std::move(label)),
      total_(std::max<size_t>(1, total)),
      start_(steady_clock::now()),
      terminal_(::isatty(STDERR_FILENO) != 0) {
  nextDraw_ = start_ + (terminal_ ? kFirstDraw : kLogInterval);
}

Progress::~Progress() {
  if (drawn_) draw(done_, true);
}

void Progress::advance(size_t steps) {
  const size_t done = done_ += steps;
  if (!progressEnabled) return;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock.owns_lock() || steady_clock::now() < nextDraw_) return;
  draw(done, false);
  nextDraw_ = steady_clock::now() + (terminal_ ? kTerminalInterval : kLogInterval);
}

void Progress::draw(size_t done, bool last) {
  drawn_ = true;
  const double share = static_cast<double>(std::min(done, total_)) / static_cast<double>(total_);
  const double seconds = std::chrono::duration<double>(steady_clock::now() - start_).count();
  std::string line;
  if (terminal_) {
    constexpr int kWidth = 30;
    const int filled = static_cast<int>(share * kWidth);
    line = fmt::format("\r{} [{}{}] {:3.0f} % {:.1f} s\x1b[K{}", label_, std::string(static_cast<size_t>(filled), '#'),
                       std::string(static_cast<size_t>(kWidth - filled), '.'), share * 100, seconds, last ? "\n" : "");
  } else {
    line = fmt::format("{}: {:.0f} % after {:.0f} s\n", label_, share * 100, seconds);
  }
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace tetralux
