#include "base/parallel.h"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tetralux {

unsigned workerCount() {
  static const unsigned count = [] {
    cpu_set_t set;
    // The affinity mask, not the machine's size: batch systems lend a part of a node.
    if (sched_getaffinity(0, sizeof set, &set) == 0) return static_cast<unsigned>(std::max(1, CPU_COUNT(&set)));
    return std::max(1u, std::thread::hardware_concurrency());
  }();
  return count;
}

void parallelFor(size_t count, size_t grain, const std::function<void(size_t, size_t, unsigned)>& body) {
  grain = std::max<size_t>(1, grain);
  const size_t ranges = (count + grain - 1) / grain;
  const unsigned threads = static_cast<unsigned>(std::min<size_t>(workerCount(), ranges));
  std::atomic<size_t> next{0};
  std::atomic<bool> stop{false};
  std::exception_ptr error;
  std::mutex errorMutex;
  auto work = [&](unsigned worker) {
    for (;;) {
      const size_t begin = next.fetch_add(grain);
      if (begin >= count || stop) return;
      try {
        body(begin, std::min(count, begin + grain), worker);
      } catch (...) {
        const std::lock_guard lock(errorMutex);
        if (!error) error = std::current_exception();
        stop = true;
      }
    }
  };
  std::vector<std::thread> pool;
  for (unsigned worker = 1; worker < threads; worker++) pool.emplace_back(work, worker);
  work(0);
  for (std::thread& thread : pool) thread.join();
  if (error) std::rethrow_exception(error);
}

}  // namespace tetralux
