#pragma once

#include <condition_variable>
#include <mutex>

namespace slicefarm {

/// An event that happens once, and that a test waits for. Thread-safe.
class Event {
 public:
  /// Marks the event as happened.
  void Happen() {
    const std::lock_guard lock(mutex_);
    happened_ = true;
    changed_.notify_all();
  }

  /// Waits until the event has happened.
  void Await() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return happened_; });
  }

  bool Happened() {
    const std::lock_guard lock(mutex_);
    return happened_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool happened_ = false;
};

}  // namespace slicefarm
