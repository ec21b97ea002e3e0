#pragma once

#include <condition_variable>
#include <mutex>

#include "common/model/layers/layer.h"

namespace slicefarm::load {

/// Limited number of requests in flight. Thread-safe.
class Slots {
 public:
  explicit Slots(int limit) : limit_(limit) {}

  /// Takes a slot. Returns false if all are taken.
  bool TryEnter() {
    const std::lock_guard lock(mutex_);
    if (taken_ == limit_) return false;
    ++taken_;
    return true;
  }

  /// Waits for a free slot and takes it.
  void Enter() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return taken_ < limit_; });
    ++taken_;
  }

  /// Releases a slot.
  void Leave() {
    // Notifies while it holds the lock: a thread that waits for the last slot may destroy this
    // object as soon as the lock is free.
    const std::lock_guard lock(mutex_);
    --taken_;
    changed_.notify_all();
  }

  /// Waits until all slots are free.
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
