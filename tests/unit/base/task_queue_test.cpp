#include "base/task_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <vector>

#include "support/expect_error.h"

namespace tetralux {
namespace {

TEST(TaskQueue, DoesEverythingInOrder) {
  for (const size_t capacity : {0u, 1u, 2u, 7u}) {
    std::vector<int> done;
    TaskQueue queue(capacity);
    for (int i = 0; i < 100; i++) queue.push([&done, i] { done.push_back(i); });
    queue.finish();
    ASSERT_EQ(done.size(), 100u);
    for (int i = 0; i < 100; i++) EXPECT_EQ(done[static_cast<size_t>(i)], i);
  }
}

TEST(TaskQueue, HoldsNoMoreThanItsCapacity) {
  std::atomic<int> unfinished = 0;
  std::atomic<int> most = 0;
  TaskQueue queue(2);
  for (int i = 0; i < 50; i++) {
    queue.push([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      unfinished--;
    });
    // Counted after push(): the task that made room may have been counted down, but not yet taken out.
    most = std::max(most.load(), ++unfinished);
  }
  queue.finish();
  EXPECT_EQ(unfinished, 0);
  EXPECT_LE(most, 2);
}

TEST(TaskQueue, GoesOnWhileATaskRuns) {
  std::atomic<bool> isReleased = false;
  TaskQueue queue(1);
  queue.push([&] {
    while (!isReleased) std::this_thread::yield();
  });
  isReleased = true;  // reached only if push() did not wait for the task
  queue.finish();
}

TEST(TaskQueue, ThreadsWorkSideBySide) {
  std::atomic<int> running = 0;
  std::atomic<int> done = 0;
  TaskQueue queue(3, 3);
  for (int i = 0; i < 6; i++) {
    queue.push([&] {
      // Each batch of three ends only if all of them run at the same time.
      const int batchEnd = 3 * (running++ / 3 + 1);
      while (running < batchEnd) std::this_thread::yield();
      done++;
    });
  }
  queue.finish();
  EXPECT_EQ(done, 6);
  EXPECT_EQ(test::errorOf(ErrorCode::Output,
                          [&] {
                            for (int i = 0; i < 9; i++) queue.push([] { fail(ErrorCode::Output, "all fail"); });
                            queue.finish();
                          }),
            "all fail");
}

TEST(TaskQueue, ThrowsWhatATaskThrewAndDropsTheOthers) {
  for (const size_t capacity : {1u, 3u}) {
    int done = 0;
    TaskQueue queue(capacity);
    const std::string message = test::errorOf(ErrorCode::Output, [&] {
      for (int i = 0; i < 10; i++) {
        queue.push([&done, i] {
          if (i == 2) fail(ErrorCode::Output, "task {}", i);
          done++;
        });
      }
      queue.finish();
    });
    EXPECT_EQ(message, "task 2");
    queue.finish();  // thrown once
    EXPECT_EQ(done, 2);
  }
}

TEST(TaskQueue, WithoutAThreadErrorsComeAtOnce) {
  TaskQueue queue(0);
  EXPECT_EQ(test::errorOf(ErrorCode::Output, [&] { queue.push([] { fail(ErrorCode::Output, "now"); }); }), "now");
}

TEST(TaskQueue, EndsAfterWhatWasGiven) {
  int done = 0;
  {
    TaskQueue queue(5);
    for (int i = 0; i < 5; i++) queue.push([&] { done++; });
  }
  EXPECT_EQ(done, 5);
}

}  // namespace
}  // namespace tetralux
