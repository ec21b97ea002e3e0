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

/// What happened to ranges since the start; for metrics.
struct DispatchCounts {
  int64_t done = 0;
  int64_t requeued = 0;
  int64_t hedged = 0;
  int64_t poisoned = 0;
  int64_t differing = 0;  ///< second answers that are unlike the first
  int64_t waiting = 0;    ///< now: ranges that no runner has
};

/// The ranges of any number of jobs over the runners there are: which range of which job a free
/// slot takes, and what its answer means for the job. A pure state machine, as RangeScheduler is,
/// of which it has one for each job.
///
/// Tenants share the runners evenly: a free slot goes to the tenant with the fewest ranges in
/// flight, of these to the one that has waited longest. Of a tenant's jobs those of the highest
/// priority come first; among equals the one with the fewest ranges in flight, then the one that
/// has waited longest. A slow range is doubled only when nothing is queued, and not more than
/// `hedge_share` of all: when everything is slow, second copies would make it slower.
///
/// A range that runners refuse (INTERNAL) is not tried as often as one that they are too busy for. A
/// range that a runner died of (UNAVAILABLE that no server has said) is tried alone on an idle
/// runner, one such range of all jobs at a time. A runner whose slots are never all free is kept
/// free for it after SchedulerOptions::elsewhere_after_s. Not thread-safe.
class FanOut {
 public:
  using JobId = int64_t;
  using Ticket = RangeScheduler::Ticket;

  struct Grant {
    JobId job = 0;
    Ticket ticket = 0;  ///< of the job
    int32_t range = 0;
    bool alone = false;  ///< nothing else goes to its runner meanwhile
  };

  /// What an error means for its job.
  enum class Verdict {
    kGoesOn,
    kInputAtFault,  ///< it ends with that error, the same anywhere
    kPoisoned,      ///< it ends: this range has failed too often
  };

  explicit FanOut(const SchedulerOptions& options = {})
      : options_(options), hedges_left_(options.hedge_burst) {}

  /// A job with so many ranges to run, by runners that know its process.
  JobId Add(int32_t ranges, Process process, Claimant claimant = {});

  /// Nothing of the job is wanted any more.
  void Remove(JobId job);

  /// What a slot of the runner, which can be reached, is to do next; `can`: the processes that the
  /// runner knows.
  std::optional<Grant> Take(RunnerId runner, double now_s, ProcessSet can = ProcessSet::All());

  /// Whether Take would grant something that is queued or suspect, or a suspect waits for the runner
  /// to be back. Slots ask this again after a
  /// while when there are suspects, and when a call comes back.
  bool MayTake(RunnerId runner, double now_s, ProcessSet can = ProcessSet::All());

  /// The call of a grant is over, whatever came of it, and also if its job was removed.
  void Returned(const Grant& grant) { loads_.End({grant.job, grant.ticket}); }

  RangeScheduler::Accepted Succeeded(const Grant& grant, double now_s);
  Verdict Failed(const Grant& grant, const absl::Status& error);
  /// The call was cancelled, as another copy of the range has made it.
  void Superseded(const Grant& grant);
  /// Two copies of a range came out differently.
  void Differed() { ++counts_.differing; }
  void RunnerGone(RunnerId runner);

  bool AllDone(JobId job) const { return jobs_.at(job).scheduler.AllDone(); }
  /// Of jobs of these processes.
  bool AnyQueued(ProcessSet can = ProcessSet::All()) const;
  bool AnySuspects() const;
  int Tries(JobId job, int32_t range) const { return jobs_.at(job).scheduler.Tries(range); }
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
  std::optional<RunnerId> kept_free_;  ///< for a suspect
  JobId next_job_ = 1;
  int64_t next_turn_ = 1;
  double hedges_left_;
  DispatchCounts counts_;  ///< of jobs that were removed; done and poisoned of all
};

/// How long a slot rests whose calls failed `failures` times in a row: twice as long each time.
std::chrono::milliseconds RestAfter(int failures, std::chrono::milliseconds min,
                                    std::chrono::milliseconds max);

}  // namespace slicefarm::coordinator
