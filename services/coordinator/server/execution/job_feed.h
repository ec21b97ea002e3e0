#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "services/coordinator/store/jobs/job_changes.h"

namespace slicefarm::coordinator {

/// Tells those who watch a job that it has new events, which they then read from the store, and how
/// far its run has come, which stands here alone.
class JobFeed {
 public:
  enum class News { kEvents, kProgress };
  using Listener = std::function<void(News news)>;

  /// `listener` is called from any thread, one call at a time; it must be quick, and call nothing
  /// of the feed but closed().
  int64_t Listen(const std::string& job_id, Listener listener);

  /// The same of any job's new events, without its progress.
  int64_t ListenToAll(Listener listener) { return Listen("", std::move(listener)); }

  /// Afterwards the listener is not called any more.
  void Forget(int64_t ticket);

  void Changed(const std::string& job_id);

  /// A job that this coordinator runs has come so far; it runs no more.
  void Progressed(const std::string& job_id, const JobProgress& progress);
  void Ended(const std::string& job_id, int64_t epoch);
  /// Jobs of another coordinator have: what it told before is of no interest any more.
  void Progressed(ProgressReport report);

  /// Of this coordinator's jobs.
  std::map<std::string, JobProgress> Running() const;
  /// None: nothing is known.
  std::optional<JobProgress> ProgressOf(const std::string& job_id) const;
  /// Puts the progress of the run under the record's claim into it, if it is RUNNING.
  void AddProgress(JobRecord& job) const;
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

  void Tell(const std::string& job_id, News news);

  std::atomic<bool> closed_ = false;
  mutable std::mutex mutex_;
  std::map<std::string, JobProgress> running_;
  std::map<std::string, ProgressReport> elsewhere_;  ///< by owner
  std::map<int64_t, Entry> entries_;
  std::multimap<std::string, int64_t, std::less<>> by_job_;
  int64_t next_ticket_ = 1;
};

}  // namespace slicefarm::coordinator
