#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "services/coordinator/run/lease_table.h"
#include "services/coordinator/server/execution/job_run.h"
#include "services/coordinator/server/execution/unfit_processes.h"

namespace slicefarm::coordinator {

/// Options of a JobRunner.
struct JobRunnerOptions {
  std::string owner;  ///< name of this coordinator; the same name after a restart
  int jobs = 2;       ///< number of jobs that run at the same time
  /// Number of further jobs that may run at the same time (guests). Each belongs to a tenant that
  /// has no running job.
  int guests = 12;
  /// Time without a renewal after which a coordinator loses its jobs.
  std::chrono::milliseconds lease{10'000};
  std::chrono::milliseconds renew{3'000};
  /// Interval of the search for jobs that other coordinators left.
  std::chrono::milliseconds poll{1'000};
};

/// Claims jobs, runs a limited number of them at a time, and renews their leases. A tenant without
/// a running job does not wait until other tenants' jobs end: its job runs as a guest and shares
/// the workers. Ends jobs that still wait at their deadlines. A job with the same work as a running
/// job stays QUEUED until that job has ended, so that it occupies no thread.
class JobRunner {
 public:
  JobRunner(RunEnvironment environment, JobRunnerOptions options);
  ~JobRunner();

  /// Releases the jobs that this coordinator held when it last ended, and starts the threads.
  /// Errors: see JobStore.
  absl::Status Start();

  /// Notifies the threads that there is a new job.
  void Wake();

  /// Ends the run of the job if this coordinator runs it. The cancel request itself is in the
  /// store.
  void Cancel(const std::string& job_id);

  /// Stops claiming jobs, and waits until the running jobs have ended, for at most `patience`.
  void Drain(std::chrono::milliseconds patience);

  /// Puts the running jobs back into the queue, and waits until their states are written.
  void Stop();

 private:
  enum class SlotKind { kAny, kInteractive, kGuest };
  void Serve(SlotKind slot);
  void Keep();
  void Judge();
  void Warn(const std::string& what, const absl::Status& why) const;
  void RenewLeases();
  void Tidy();
  int32_t EndOverdue();
  bool StagesFit(const JobRecord& job) const;
  absl::StatusOr<std::optional<JobRecord>> ClaimFitting(SlotKind slot, int64_t now_us);
  bool HasSpace();
  bool MayClaim(SlotKind slot);
  void Count(SlotKind slot, int more);
  std::unique_ptr<JobRun> Claim(SlotKind slot);
  bool Adopt(JobRecord& job);
  int64_t NowUs() const { return environment_.now_us(); }

  RunEnvironment environment_;
  const JobRunnerOptions options_;
  UnfitProcesses unfit_;
  /// True if the store is nearly full. The log then contains a warning.
  std::atomic<bool> low_on_space_ = false;
  /// Held during a claim, because concurrent claims would wait for each other in the store.
  std::mutex claim_mutex_;
  std::mutex mutex_;
  std::condition_variable wake_;
  LeaseTable leases_;          ///< leases of the running jobs
  int64_t calm_since_us_ = 0;  ///< start of this program, or time of the last lost lease
  bool unanswered_ = false;    ///< true if the last renewal failed or has no answer yet
  int at_work_ = 0;            ///< threads that claim or run a job
  /// number of running jobs that are neither guests nor in the slot for interactive jobs
  int at_any_ = 0;
  bool draining_ = false;
  bool stopping_ = false;
  int64_t wakes_ = 0;
  int64_t guests_asked_ = -1;  ///< value of wakes_ when a guest's thread last searched for a job
  std::vector<std::thread> threads_;
};

}  // namespace slicefarm::coordinator
