#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "common/base/cancel_token.h"
#include "common/base/span_log.h"
#include "common/base/stopwatch.h"
#include "common/rpc/observe/json_log.h"
#include "common/stage/memory_budget.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"
#include "services/coordinator/run/lost_runs.h"
#include "services/coordinator/run/progress_gate.h"
#include "services/coordinator/run/run_steps.h"
#include "services/coordinator/run/run_wishes.h"
#include "services/coordinator/server/execution/job_feed.h"
#include "services/coordinator/server/execution/job_results.h"
#include "services/coordinator/server/execution/resolved_jobs.h"
#include "services/coordinator/server/messages/job_request.h"

namespace slicefarm::coordinator {

/// What all runs share. Everything outlives the runs.
struct RunEnvironment {
  JobStore& jobs;
  BlobStores& blobs;
  ResolvedJobs& resolved;
  JobResults& results;
  const JobPipeline& pipeline;
  MemoryBudget& memory;
  JobFeed& feed;
  std::function<int64_t()> now_us;
  std::string build_id;
  ResultSharing sharing = ResultSharing::kOff;
  rpc::JsonLog log;
  /// Told what the stages took for each job that was computed.
  std::function<void(const StageTimes&)> computed = [](const StageTimes&) {};
  /// Whether the stages that all jobs need are of this build: asked before a job is claimed, once a
  /// run has met others.
  std::function<bool()> stages_fit = [] { return true; };
  /// Whether what a run makes can be kept: asked before a job is claimed.
  std::function<bool()> room = [] { return true; };
};

/// One claimed job, from the claim to what it came to: takes the steps of RunSteps.
/// It ends as SUCCEEDED, FAILED or CANCELLED; or goes back to QUEUED, as Conclusion says. If that
/// cannot be written, the lease runs out and the job is claimed again. After a fencing nothing is
/// written any more.
class JobRun {
 public:
  /// `calm_us`: how long its coordinator has been calm, as LostRuns has it.
  JobRun(RunEnvironment& environment, JobRecord job, int64_t calm_us);

  void Run();

  /// True of a run that is over and wrote no end.
  bool lost() const { return !ended_; }

  /// True of a run that ended because stages are of another build.
  bool met_other_build() const { return met_other_build_; }

  const Lease& lease() const { return lease_; }
  /// Shared with those who give the run up.
  const std::shared_ptr<RunWishes>& wishes() const { return wishes_; }

 private:
  absl::StatusOr<bool> Take(RunSteps::Step step, const absl::Status& error);
  absl::StatusOr<bool> FindCached();
  absl::StatusOr<bool> Begin();
  absl::StatusOr<bool> Compute();
  absl::StatusOr<bool> Keep();
  absl::StatusOr<bool> Conclude(const absl::Status& error);
  CancelToken GivenUp() const;
  void Progress(PipelineProgress progress);
  absl::Status WriteAtLast(const JobUpdate& update);
  absl::Status Write(JobUpdate update);
  absl::Status Written(const absl::Status& status);
  std::string KeepTrace(std::string_view outcome);
  rpc::LogFields Fields(const rpc::LogFields& more) const;

  RunEnvironment& environment_;
  const JobRecord job_;
  const LostRuns lost_runs_;
  const std::string result_tenant_;
  const Lease lease_;
  const std::shared_ptr<RunWishes> wishes_ = std::make_shared<RunWishes>(job_.deadline_us);
  std::shared_ptr<const ResolvedJob> resolved_;  ///< from FindCached on
  std::optional<RunOutput> output_;              ///< from Compute to Keep
  ProgressGate progress_;
  bool ended_ = false;
  bool met_other_build_ = false;
  Stopwatch clock_;
  SpanLog spans_;
  const int64_t begin_us_ = spans_.NowUs();
};

}  // namespace slicefarm::coordinator
