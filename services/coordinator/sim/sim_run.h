#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "services/coordinator/algo/pipeline/job_pipeline.h"
#include "services/coordinator/run/run_steps.h"
#include "services/coordinator/sim/sim_dispatcher.h"
#include "services/coordinator/sim/store_link.h"

namespace slicefarm::coordinator::sim {

/// What the runs of a coordinator share.
struct RunDesk {
  World& world;
  Process& process;
  StoreLink& link;
  SimDispatcher& dispatcher;
  std::string build;
  std::function<int64_t()> now_us;
};

/// JobRun without a thread: takes the steps of RunSteps, each of which goes on when the store or
/// the workers have answered.
class SimRun : public std::enable_shared_from_this<SimRun> {
 public:
  SimRun(RunDesk& desk, Work work, JobRecord job);

  /// `over` is called once, unless the coordinator dies before.
  void Start(std::function<void()> over);

  /// The wishes may have changed.
  void Notice();

  const Lease& lease() const { return lease_; }
  const std::shared_ptr<RunWishes>& wishes() const { return wishes_; }

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
  void Write(JobUpdate update, Then then);

  RunDesk& desk_;
  const Work work_;
  const JobRecord job_;
  const Lease lease_;
  const std::shared_ptr<RunWishes> wishes_;
  std::function<void()> over_;
  RunSteps steps_{job_};
  PipelineProgress told_;
  bool computing_ = false;
  std::optional<FanOut::JobId> fan_out_;  ///< while its ranges run
  RangeHashes layers_;
  bool fenced_ = false;  ///< it was told so
};

}  // namespace slicefarm::coordinator::sim
