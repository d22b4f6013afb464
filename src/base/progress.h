// Shows how far a long piece of work has come, on standard error.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace tetralux {

// Switches every progress display off (--quiet) or on again. On by default.
void setProgressEnabled(bool enabled);

// A bar on a terminal, redrawn at most ten times a second; elsewhere a line every ten seconds. Nothing is shown for
// work that ends within half a second.
class Progress {
 public:
  //   label   what is done, in a few words
  //   total   number of steps, >= 1
  Progress(std::string label, size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Adds steps done. May be called from any thread.
  void advance(size_t steps = 1);

 private:
  void draw(size_t done, bool last);

  std::string label_;
  size_t total_;
  std::atomic<size_t> done_{0};
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point nextDraw_;
  std::mutex mutex_;
  bool terminal_;
  bool drawn_ = false;
};

}  // namespace tetralux
