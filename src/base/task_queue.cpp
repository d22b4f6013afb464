#include "base/task_queue.h"

#include <utility>

namespace tetralux {

TaskQueue::TaskQueue(size_t capacity) : capacity_(capacity) {
  if (capacity > 0) thread_ = std::thread([this] { work(); });
}

TaskQueue::~TaskQueue() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    isOver_ = true;
  }
  given_.notify_one();
  thread_.join();
}

void TaskQueue::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    given_.wait(lock, [&] { return isOver_ || !tasks_.empty(); });
    if (tasks_.empty()) return;
    if (!hasFailed_) {
      std::function<void()>& task = tasks_.front();  // push() moves no elements
      lock.unlock();
      std::exception_ptr error;
      try {
        task();
      } catch (...) {
        error = std::current_exception();
      }
      task = nullptr;  // what it holds goes before there is room for another
      lock.lock();
      error_ = error;
      hasFailed_ = error != nullptr;
    }
    tasks_.pop_front();
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
    done_.wait(lock, [&] { return hasFailed_ || tasks_.size() < capacity_; });
    throwError(lock);
    tasks_.push_back(std::move(task));
  }
  given_.notify_one();
}

void TaskQueue::finish() {
  std::unique_lock lock(mutex_);
  done_.wait(lock, [&] { return tasks_.empty(); });
  throwError(lock);
}

}  // namespace tetralux
