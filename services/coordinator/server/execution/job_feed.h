#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>

namespace slicefarm::coordinator {

/// Tells those who watch a job that it has new events, which they then read from the store.
class JobFeed {
 public:
  using Listener = std::function<void()>;

  /// `listener` is called from any thread, one call at a time; it must be quick, and call nothing
  /// of the feed but closed().
  int64_t Listen(const std::string& job_id, Listener listener);

  /// Afterwards the listener is not called any more.
  void Forget(int64_t ticket);

  void Changed(const std::string& job_id);
  /// Any of them may have.
  void AllChanged();

  /// The coordinator ends: calls all listeners, for which closed() is true from now on.
  void Close();
  bool closed() const { return closed_; }

 private:
  struct Entry {
    std::string job_id;
    Listener listener;
  };

  std::atomic<bool> closed_ = false;
  std::mutex mutex_;
  std::map<int64_t, Entry> entries_;
  std::multimap<std::string, int64_t, std::less<>> by_job_;
  int64_t next_ticket_ = 1;
};

}  // namespace slicefarm::coordinator
