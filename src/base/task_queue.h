// Work that is done on threads of its own while its giver goes on.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace tetralux {

// Tasks begin in the order they were given; on one thread, each ends before the next begins. After the first that
// throws, those that have not begun are dropped.
class TaskQueue {
 public:
  //   capacity      tasks that may be unfinished at a time; with 0 there is no thread, and push() does the task itself
  //   threadCount   at least 1
  explicit TaskQueue(size_t capacity, unsigned threadCount = 1);
  // Finishes what was given. Errors are dropped: finish() is for those.
  ~TaskQueue();
  TaskQueue(const TaskQueue&) = delete;
  TaskQueue& operator=(const TaskQueue&) = delete;

  // Waits until there is room. Throws what a task threw, if one has; this one is then not done.
  //   task   everything that it refers to must live until it is done
  void push(std::function<void()> task);

  // Waits until all tasks are done. Throws what a task threw.
  void finish();

 private:
  void work();
  void throwError(std::unique_lock<std::mutex>& lock);

  const size_t capacity_;
  std::mutex mutex_;
  std::condition_variable given_;  // a task, or the end
  std::condition_variable done_;
  std::deque<std::function<void()>> tasks_;  // not begun
  size_t unfinished_ = 0;                    // those, and those that run
  std::exception_ptr error_;                 // until it is thrown
  bool hasFailed_ = false;
  bool isOver_ = false;
  std::vector<std::thread> threads_;  // last: the others are there when they start
};

}  // namespace tetralux
