// Work that is done on a thread of its own, in order, while its giver goes on.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace tetralux {

// Tasks run one after the other, in the order they were given. After the first that throws, the others are dropped.
class TaskQueue {
 public:
  //   capacity   tasks that may be unfinished at a time; with 0 there is no thread, and push() does the task itself
  explicit TaskQueue(size_t capacity);
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
  std::deque<std::function<void()>> tasks_;  // the first is being done
  std::exception_ptr error_;                 // until it is thrown
  bool hasFailed_ = false;
  bool isOver_ = false;
  std::thread thread_;  // last: the others are there when it starts
};

}  // namespace tetralux
