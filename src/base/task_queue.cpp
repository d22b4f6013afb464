#include "base/task_queue.h"

#include <utility>

namespace tetralux {

TaskQueue::TaskQueue(size_t capacity, unsigned threadCount) : capacity_(capacity) {
  if (capacity == 0) return;
  for (unsigned i = 0; i < threadCount; i++) threads_.emplace_back([this] { work(); });
}

TaskQueue::~TaskQueue() {
  {
    const std::lock_guard lock(mutex_);
    isOver_ = true;
  }
  given_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void TaskQueue::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    given_.wait(lock, [&] { return isOver_ || !tasks_.empty(); });
    if (tasks_.empty()) return;
    std::function<void()> task = std::move(tasks_.front());
    tasks_.pop_front();
    if (!hasFailed_) {
      lock.unlock();
      std::exception_ptr error;
      try {
        task();
      } catch (...) {
        error = std::current_exception();
      }
      task = nullptr;  // what it holds goes before there is room for another
      lock.lock();
      if (error && !hasFailed_) error_ = error;
      hasFailed_ = hasFailed_ || error;
    }
    unfinished_--;
    done_.notify_all();
  }
}

void TaskQueue::throwError(std::unique_lock<std::mutex>& lock) {
  if (!error_) return;
  const std::exception_ptr error = std::exchange(error_, nullptr);
  lock.unlock();
  std::rethrow_exception(error);
}

void TaskQueue::push(std::function<void()> task) {
  if (capacity_ == 0) {
    task();
    return;
  }
  {
    std::unique_lock lock(mutex_);
    done_.wait(lock, [&] { return hasFailed_ || unfinished_ < capacity_; });
    throwError(lock);
    tasks_.push_back(std::move(task));
    unfinished_++;
  }
  given_.notify_one();
}

void TaskQueue::finish() {
  std::unique_lock lock(mutex_);
  done_.wait(lock, [&] { return unfinished_ == 0; });
  throwError(lock);
}

}  // namespace tetralux
