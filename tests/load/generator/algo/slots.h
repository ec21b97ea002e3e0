#pragma once

#include <condition_variable>
#include <mutex>

#include "common/model/layers/layer.h"

namespace slicefarm::load {

/// How many requests may be in flight. Thread-safe.
class Slots {
 public:
  explicit Slots(int limit) : limit_(limit) {}

  /// False if all are taken.
  bool TryEnter() {
    const std::lock_guard lock(mutex_);
    if (taken_ == limit_) return false;
    ++taken_;
    return true;
  }

  /// Waits for a free one.
  void Enter() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return taken_ < limit_; });
    ++taken_;
  }

  void Leave() {
    // Notifies under the lock: who waits for the last one may then take this object away.
    const std::lock_guard lock(mutex_);
    --taken_;
    changed_.notify_all();
  }

  void AwaitAllFree() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return taken_ == 0; });
  }

 private:
  const int limit_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int taken_ = 0;
};

}  // namespace slicefarm::load
