#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace slicefarm::coordinator {

/// Reads a value from a source that may block for long, such as a database without an answer, for
/// callers that cannot wait. Thread-safe.
template <typename T>
class PatientLook {
 public:
  /// Starts a thread that calls `look`, one call at a time. The destructor waits for the end of a
  /// running call.
  PatientLook(std::function<T()> look, std::chrono::milliseconds patience)
      : look_(std::move(look)), patience_(patience) {}

  /// Returns the result of a `look` that began after this call. Returns nullopt if none ended
  /// within the patience.
  std::optional<T> Get() {
    std::unique_lock lock(mutex_);
    const int64_t wanted = begun_ + 1;
    asked_ = true;
    changed_.notify_all();
    if (!changed_.wait_for(lock, patience_, [&] { return ended_ >= wanted; })) return std::nullopt;
    return found_;
  }

 private:
  void Run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [this] { return asked_; })) {
      asked_ = false;
      const int64_t mine = ++begun_;
      lock.unlock();
      T found = look_();
      lock.lock();
      found_ = std::move(found);
      ended_ = mine;
      changed_.notify_all();
    }
  }

  const std::function<T()> look_;
  const std::chrono::milliseconds patience_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  bool asked_ = false;
  int64_t begun_ = 0;  ///< number of looks that began
  int64_t ended_ = 0;  ///< number of the last look that ended
  std::optional<T> found_;
  // Last member, because the thread uses the other members.
  std::jthread thread_{[this](const std::stop_token& stop) { Run(stop); }};
};

}  // namespace slicefarm::coordinator
