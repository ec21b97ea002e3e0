#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "services/coordinator/algo/pipeline/job_pipeline.h"
#include "services/coordinator/run/lost_runs.h"
#include "services/coordinator/run/run_steps.h"
#include "tests/sim/sim_dispatcher.h"
#include "tests/sim/store_link.h"

namespace slicefarm::coordinator::sim {

/// Objects that the runs of a coordinator share.
struct RunDesk {
  World& world;
  Process& process;
  StoreLink& link;
  SimDispatcher& dispatcher;
  std::string build;
  /// Clock of the coordinator, in us.
  std::function<int64_t()> now_us;
  std::function<void()> die;  ///< kills the coordinator because of the job that it runs
};

/// JobRun without a thread. Takes the steps of RunSteps; each step continues when the store or the
/// workers have answered.
class SimRun : public std::enable_shared_from_this<SimRun> {
 public:
  SimRun(RunDesk& desk, Work work, JobRecord job, int64_t calm_us);

  /// Starts the run. Calls `over` once, unless the coordinator dies before.
  void Start(std::function<void()> over);

  /// Checks whether the run must end, because its requests may have changed.
  void Notice();

  /// Returns true if the run has written no end, as in JobRun.
  bool lost() const { return !ended_; }

  /// Returns the lease of the job.
  const Lease& lease() const { return lease_; }
  /// Returns the requests to end the run.
  const std::shared_ptr<RunRequests>& wishes() const { return wishes_; }

 private:
  using Then = std::function<void(const absl::Status&)>;

  void Advance();
  void Took(const absl::StatusOr<bool>& succeeded);
  void FindCached();
  void CheckBlobs(const JobResult& found);
  void ForgetResult();
  void Compute();
  void Sliced();
  void Computed(absl::StatusOr<RangeHashes> layers);
  void Keep();
  void PutBlobs();
  void Conclude();
  void WriteAtLast(const JobUpdate& update, int writes);
  void Write(JobUpdate update, Then then);

  RunDesk& desk_;
  const Work work_;
  const JobRecord job_;
  const LostRuns lost_runs_;
  const Lease lease_;
  const std::shared_ptr<RunRequests> wishes_;
  std::function<void()> over_;
  RunSteps steps_{lost_runs_};
  PipelineProgress reported_;
  bool computing_ = false;
  /// job in the dispatcher; set while the ranges of this run are in progress
  std::optional<FanOut::JobId> fan_out_;
  RangeHashes layers_;
  bool ended_ = false;
  /// true if the store has refused a write of this run, because the job was claimed again
  bool fenced_ = false;
};

}  // namespace slicefarm::coordinator::sim
