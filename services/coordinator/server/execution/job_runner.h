#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "services/coordinator/run/lease_book.h"
#include "services/coordinator/server/execution/job_run.h"

namespace slicefarm::coordinator {

struct JobRunnerOptions {
  std::string owner;  ///< names this coordinator; the same again after a restart
  int jobs = 2;       ///< at the same time
  /// At the same time beyond these, each of a tenant none of whose jobs runs.
  int guests = 12;
  std::chrono::milliseconds lease{
      10'000};  ///< a coordinator that is silent this long loses its jobs
  std::chrono::milliseconds renew{3'000};
  std::chrono::milliseconds poll{
      1'000};  ///< how often to look for jobs that other coordinators left
};

/// Claims jobs and runs them, a bounded number at a time, and holds their leases; a tenant none of
/// whose jobs runs does not wait for the end of others' jobs: his are guests, and share the workers
/// from then on; ends those that
/// wait beyond their deadlines. A job that does the work of a running one stays QUEUED until that
/// has ended, so that it keeps no thread from others.
class JobRunner {
 public:
  JobRunner(RunEnvironment environment, JobRunnerOptions options);
  ~JobRunner();

  /// Takes over what an earlier life of this coordinator left, and begins. Errors: the store's.
  absl::Status Start();

  /// There is a new job.
  void Wake();

  /// Ends the job's run, if it runs here. The request itself stands in the store.
  void Cancel(const std::string& job_id);

  /// Claims no job any more, and waits until those that run have ended, `patience` at most.
  void Drain(std::chrono::milliseconds patience);

  /// Hands the running jobs back to the queue, and returns when that is written.
  void Stop();

 private:
  enum class Place { kAny, kInteractive, kGuest };
  void Serve(Place place);
  void Keep();
  void Judge();
  void Warn(const std::string& what, const absl::Status& why) const;
  void RenewLeases();
  void Tidy();
  int32_t EndOverdue();
  bool StagesFit();
  bool HasRoom();
  bool MayClaim(Place place);
  void Count(Place place, int more);
  std::unique_ptr<JobRun> Claim(Place place);
  bool Adopt(JobRecord& job);
  int64_t NowUs() const { return environment_.now_us(); }

  RunEnvironment environment_;
  const JobRunnerOptions options_;
  std::atomic<bool> met_other_build_ = false;  ///< a run did, and stages were not seen to fit since
  std::atomic<bool> without_room_ = false;     ///< and said so
  std::mutex claim_mutex_;  ///< one claim at a time: more would wait for each other in the store
  std::mutex mutex_;
  std::condition_variable wake_;
  LeaseBook leases_;           ///< of the jobs that run
  int64_t calm_since_us_ = 0;  ///< this life began, or lost a claim
  bool unanswered_ = false;    ///< the last renewal failed, or is still under way
  int at_work_ = 0;            ///< threads that claim or run a job
  int at_any_ = 0;             ///< jobs that run at places for any
  bool draining_ = false;
  bool stopping_ = false;
  int64_t wakes_ = 0;
  int64_t guests_asked_ = -1;  ///< the wake after which a guest asked the store last
  std::vector<std::thread> threads_;
};

}  // namespace slicefarm::coordinator
