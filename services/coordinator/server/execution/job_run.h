#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "common/base/cancel_token.h"
#include "common/base/span_log.h"
#include "common/base/stopwatch.h"
#include "common/model/process.h"
#include "common/rpc/observe/json_log.h"
#include "common/stage/memory_budget.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"
#include "services/coordinator/run/lost_runs.h"
#include "services/coordinator/run/progress_throttle.h"
#include "services/coordinator/run/run_requests.h"
#include "services/coordinator/run/run_steps.h"
#include "services/coordinator/server/execution/job_feed.h"
#include "services/coordinator/server/execution/job_results.h"
#include "services/coordinator/server/execution/resolved_jobs.h"
#include "services/coordinator/server/messages/job_request.h"

namespace slicefarm::coordinator {

/// Objects that all runs share. All of them must outlive the runs.
struct RunEnvironment {
  JobStore& jobs;
  BlobStores& blobs;
  ResolvedJobs& resolved;
  JobResults& results;
  const JobPipeline& pipeline;
  MemoryBudget& memory;
  JobFeed& feed;
  /// Clock of the coordinator, in us.
  std::function<int64_t()> now_us;
  std::string build_id;
  ResultSharing sharing = ResultSharing::kOff;
  rpc::JsonLog log;
  /// Receives the stage times of each job that was computed.
  std::function<void(const StageTimes&)> computed = [](const StageTimes&) {};
  /// Returns true if the stages that jobs of a process need are reachable and of this build. After
  /// a run of the process has met another stage, this function is called before each claim.
  std::function<bool(Process)> stages_fit = [](Process) { return true; };
  /// Returns true if the stores have space for the result of a run. Called before each claim.
  std::function<bool()> has_space = [] { return true; };
};

/// Run of one claimed job, from the claim to its end. Takes the steps of RunSteps. At the end, the
/// job is SUCCEEDED, FAILED or CANCELLED, or returns to QUEUED (run_conclusion.h). If the end
/// cannot be written, the lease expires and the job is claimed again. A run that has lost its lease
/// writes nothing more.
class JobRun {
 public:
  /// Creates the run of a claimed job. `calm_us`: time for which this coordinator has run
  /// without losing a lease (LostRuns).
  JobRun(RunEnvironment& environment, JobRecord job, int64_t calm_us);

  /// Takes all steps of the run. Returns when the run is over.
  void Run();

  /// Returns true if the run is over but has written no end.
  bool lost() const { return !ended_; }

  /// Returns the job's process if the run ended because stages are of another build or not
  /// reachable.
  std::optional<Process> met_unfit_stages() const { return met_unfit_stages_; }

  /// Returns the lease of the job.
  const Lease& lease() const { return lease_; }
  /// Returns the requests to end the run, shared with the code that sets them.
  const std::shared_ptr<RunRequests>& wishes() const { return wishes_; }

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
  const std::shared_ptr<RunRequests> wishes_ = std::make_shared<RunRequests>(job_.deadline_us);
  std::shared_ptr<const ResolvedJob> resolved_;  ///< set by FindCached
  std::optional<RunOutput> output_;              ///< set by Compute, removed by Keep
  ProgressThrottle progress_;
  bool ended_ = false;
  std::optional<Process> met_unfit_stages_;
  Stopwatch clock_;
  SpanLog spans_;
  const int64_t begin_us_ = spans_.NowUs();
};

}  // namespace slicefarm::coordinator
