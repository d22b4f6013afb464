#include "base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace tetralux {
namespace {

TEST(ParallelFor, VisitsEveryIndexOnce) {
  for (const size_t count : {0u, 1u, 2u, 7u, 1000u}) {
    for (const size_t grain : {0u, 1u, 3u, 2000u}) {
      std::vector<std::atomic<int>> visits(count);
      parallelFor(count, grain, [&](size_t begin, size_t end, unsigned worker) {
        EXPECT_LT(worker, workerCount());
        EXPECT_LE(end - begin, std::max<size_t>(grain, 1));
        for (size_t i = begin; i < end; i++) visits[i]++;
      });
      for (const auto& v : visits) EXPECT_EQ(v, 1);
    }
  }
}

TEST(ParallelFor, PassesOnAnException) {
  EXPECT_THROW(parallelFor(100, 1,
                           [](size_t begin, size_t, unsigned) {
                             if (begin == 50) throw std::runtime_error("50");
                           }),
               std::runtime_error);
}

}  // namespace
}  // namespace tetralux
