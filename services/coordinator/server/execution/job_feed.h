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

/// Notifies listeners of a job that there are new events or new progress. Listeners read the events
/// themselves from the store. The progress of a run is stored only in the feed.
class JobFeed {
 public:
  /// Kind of a notification.
  enum class News { kEvents, kProgress };
  using Listener = std::function<void(News news)>;

  /// Adds a listener for a job and returns its ticket. `listener` is called from any thread, one
  /// call at a time. It must be quick, and the only function of the feed that it may call is
  /// closed().
  int64_t Listen(const std::string& job_id, Listener listener);

  /// Adds a listener for new events of all jobs, without their progress.
  int64_t ListenToAll(Listener listener) { return Listen("", std::move(listener)); }

  /// Removes the listener with this ticket. After the return, the listener is not called any more.
  void Forget(int64_t ticket);

  /// Notifies the listeners of the job about new events.
  void Changed(const std::string& job_id);

  /// Stores the progress of a job that this coordinator runs, and notifies its listeners.
  void Progressed(const std::string& job_id, const JobProgress& progress);
  /// Forgets the progress of a run that has ended. `epoch`: the epoch of the run's lease.
  void Ended(const std::string& job_id, int64_t epoch);
  /// Stores the progress of another coordinator's jobs in place of its previous report. Notifies
  /// the listeners of changed jobs.
  void Progressed(ProgressReport report);

  /// Returns the progress of this coordinator's jobs.
  std::map<std::string, JobProgress> Running() const;
  /// Returns the latest progress of a job; nullopt if it is unknown.
  std::optional<JobProgress> ProgressOf(const std::string& job_id) const;
  /// Adds the current progress to a RUNNING record. Ignores progress of a run with another epoch.
  void AddProgress(JobRecord& job) const;
  /// Notifies all listeners, because any job may have new events.
  void AllChanged();

  /// Notifies all listeners that the coordinator stops. From now on, closed() returns true.
  void Close();
  /// Returns true after Close.
  bool closed() const { return closed_; }

 private:
  struct Entry {
    std::string job_id;
    Listener listener;
  };

  void Notify(const std::string& job_id, News news);

  std::atomic<bool> closed_ = false;
  mutable std::mutex mutex_;
  std::map<std::string, JobProgress> running_;
  /// Progress of other coordinators, by their names.
  std::map<std::string, ProgressReport> elsewhere_;
  std::map<int64_t, Entry> entries_;
  std::multimap<std::string, int64_t, std::less<>> by_job_;
  int64_t next_ticket_ = 1;
};

}  // namespace slicefarm::coordinator
