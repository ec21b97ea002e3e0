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

/// Looks at something that may not answer for long, such as a database that stands still, for those
/// who cannot wait for it. Thread-safe.
template <typename T>
class PatientLook {
 public:
  /// `look` runs on a thread of its own, one at a time. The destructor waits for one that is under
  /// way.
  PatientLook(std::function<T()> look, std::chrono::milliseconds patience)
      : look_(std::move(look)), patience_(patience) {}

  /// What a look that began after this call found; nullopt: none came to its end within the
  /// patience.
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
  int64_t begun_ = 0;  ///< looks
  int64_t ended_ = 0;  ///< the last one that did
  std::optional<T> found_;
  std::jthread thread_{[this](const std::stop_token& stop) { Run(stop); }};  // the last member
};

}  // namespace slicefarm::coordinator
