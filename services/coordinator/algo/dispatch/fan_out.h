#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "absl/status/status.h"
#include "common/stage/task.h"
#include "services/coordinator/algo/dispatch/range_scheduler.h"
#include "services/coordinator/algo/dispatch/runner_loads.h"
#include "services/coordinator/algo/dispatch/runner_set.h"

namespace slicefarm::coordinator {

/// Counts of range outcomes since the start, for metrics.
struct DispatchCounts {
  int64_t done = 0;
  int64_t requeued = 0;
  int64_t hedged = 0;
  int64_t poisoned = 0;
  int64_t differing = 0;  ///< second results that differ from the first result of their range
  int64_t waiting = 0;    ///< ranges that no runner has at the moment
};

/// Decides which range of which job a free slot gets, and how a range's result changes its job. A
/// pure state machine for any number of jobs and runners. It has one RangeScheduler per job.
///
/// Tenants share the runners evenly: a free slot goes to the tenant with the fewest ranges in
/// flight; if several tenants have the same number, to the one that has waited longest. Within a
/// tenant, the jobs of the highest priority come first. Among jobs of the same priority, the job
/// with the fewest ranges in flight comes first, then the one that has waited longest.
///
/// A slow range gets a second copy on another runner only when nothing is queued. Second copies are
/// at most `hedge_share` of all ranges, because more of them would slow down a busy farm further.
///
/// The error of a failed range decides about its next tries. INTERNAL: the runner refused the
/// range, which gets fewer tries than after other errors (such as a busy runner). UNAVAILABLE that
/// no server sent: the runner probably died of the range, which is then suspect and is tried alone
/// on an idle runner. Of all jobs, only one suspect range runs at a time. If it has waited for
/// SchedulerOptions::elsewhere_after_s and no runner is idle, one runner gets no other ranges until
/// it is idle. Not thread-safe.
class FanOut {
 public:
  using JobId = int64_t;
  using Ticket = RangeScheduler::Ticket;

  /// Permission for a slot to run one copy of a range.
  struct Grant {
    JobId job = 0;
    Ticket ticket = 0;  ///< ticket of the copy in the job's scheduler
    int32_t range = 0;
    bool alone = false;  ///< true if the runner gets no other range until this copy ends
  };

  /// Effect of a range's error on its job.
  enum class Verdict {
    kGoesOn,
    kInputAtFault,  ///< the job ends with this error, because every runner would report it
    kPoisoned,      ///< the job ends, because this range has failed too often
  };

  explicit FanOut(const SchedulerOptions& options = {})
      : options_(options), hedges_left_(options.hedge_burst) {}

  /// Adds a job with `ranges` ranges, for runners that support `process`.
  JobId Add(int32_t ranges, Process process, Claimant claimant = {});

  /// Removes the job. Later results of its ranges are ignored.
  void Remove(JobId job);

  /// Returns the next range for a free slot of the runner; nullopt if there is none. In this
  /// function and the next ones, `can` contains the processes that the runner supports. REQUIRES:
  /// the runner can be reached.
  std::optional<Grant> Take(RunnerId runner, double now_s, ProcessSet can = ProcessSet::All());

  /// Returns true if Take would return a queued or a suspect range. Also returns true if a suspect
  /// range waits until this runner can be reached again. Second copies of slow ranges are not
  /// considered. A slot without work calls this function whenever a call of another slot ends, and
  /// from time to time if there are suspect ranges.
  bool MayTake(RunnerId runner, double now_s, ProcessSet can = ProcessSet::All());

  /// Records that the call of a grant has ended, no matter how. The job may have been removed.
  void Returned(const Grant& grant) { loads_.End({grant.job, grant.ticket}); }

  /// Records a result of the granted range. The return value contains whether this is the range's
  /// first result, and the copies to cancel.
  RangeScheduler::Accepted Succeeded(const Grant& grant, double now_s);
  /// Records a failed try of the granted range and returns the effect on the job.
  Verdict Failed(const Grant& grant, const absl::Status& error);
  /// Records that the call was cancelled because another copy of the range has finished.
  void Superseded(const Grant& grant);
  /// Counts a range of which two copies had different results.
  void Differed() { ++counts_.differing; }
  /// Removes the runner. The ranges that it runs return to the queue.
  void RunnerGone(RunnerId runner);

  /// Returns true if all ranges of the job are done.
  bool AllDone(JobId job) const { return jobs_.at(job).scheduler.AllDone(); }
  /// Returns true if a job of one of the processes `can` has a queued range.
  bool AnyQueued(ProcessSet can = ProcessSet::All()) const;
  /// Returns true if any job has a suspect range.
  bool AnySuspects() const;
  /// Returns the number of failed tries of the range.
  int Tries(JobId job, int32_t range) const { return jobs_.at(job).scheduler.Tries(range); }
  /// Returns the counts of all jobs since the start of this object, and the number of ranges that
  /// wait now.
  DispatchCounts Counts() const;

 private:
  struct Job {
    RangeScheduler scheduler;
    Claimant claimant;
    Process process;
    int64_t last_turn = 0;
  };

  std::vector<JobId> Order(ProcessSet can) const;
  Grant Granted(JobId id, Job& job, RunnerId runner, const RangeScheduler::Grant& grant);
  bool IsKeptFree(RunnerId runner, double now_s, ProcessSet can);
  std::optional<JobId> SuspectsJob(RunnerId runner, double now_s, ProcessSet can);
  RangeScheduler* Find(JobId job);

  SchedulerOptions options_;
  std::map<JobId, Job> jobs_;
  RunnerLoads loads_;
  /// Runner that gets no new ranges until a suspect range can run on it.
  std::optional<RunnerId> kept_free_;
  JobId next_job_ = 1;
  int64_t next_turn_ = 1;
  double hedges_left_;
  /// Counts of ranges. `requeued` and `hedged` count only ranges of removed jobs; the scheduler of
  /// each other job has its own counts.
  DispatchCounts counts_;
};

/// Returns the pause of a slot after `failures` failed calls in a row: `min`, doubled by each
/// further failure, up to `max`.
std::chrono::milliseconds RestAfter(int failures, std::chrono::milliseconds min,
                                    std::chrono::milliseconds max);

}  // namespace slicefarm::coordinator
