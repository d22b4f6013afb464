// Loops over all processors.
#pragma once

#include <cstddef>
#include <functional>

namespace tetralux {

// Number of threads that parallelFor uses: all processors this process may run on, at least 1.
unsigned workerCount();

// Calls body(begin, end, worker) for ranges that cover [0, count) once each, on workerCount() threads.
//   grain   longest range, >= 1; ranges are handed out in ascending order as threads become free
//   body    worker is in [0, workerCount()); the first exception thrown stops the loop and is thrown again here
void parallelFor(size_t count, size_t grain,
                 const std::function<void(size_t begin, size_t end, unsigned worker)>& body);

}  // namespace tetralux
