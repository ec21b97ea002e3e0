#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

#include "common/base/cancel_token.h"

namespace slicefarm {

/// Sleeps for `time`, or until a stop is requested. Returns false if a stop is requested.
inline bool SleepUnlessStopped(const std::stop_token& stop, std::chrono::milliseconds time) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  never.wait_for(lock, stop, time, [] { return false; });
  return !stop.stop_requested();
}

/// Sleeps for `time`, or until the token is cancelled. The token is polled every 50 ms. Errors:
/// CANCELLED.
inline absl::Status SleepUnlessCancelled(const CancelToken& cancel,
                                         std::chrono::milliseconds time) {
  const auto until = std::chrono::steady_clock::now() + time;
  for (;;) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    const auto now = std::chrono::steady_clock::now();
    if (now >= until) return absl::OkStatus();
    std::this_thread::sleep_until(std::min(until, now + std::chrono::milliseconds(50)));
  }
}

}  // namespace slicefarm
