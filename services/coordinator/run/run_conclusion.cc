#include "services/coordinator/run/run_conclusion.h"

#include <algorithm>

#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kMaxRetries = 5;
constexpr int64_t kFirstRetryUs = 500'000;
constexpr int64_t kNoSpacePauseUs = 1'000'000;
constexpr int64_t kStageAwayPauseUs = 1'000'000;
constexpr int64_t kUpgradePauseUs = 5'000'000;
constexpr int64_t kDiskFullRetryUs = 10'000'000;
constexpr int64_t kMaxRetryUs = 60'000'000;

/// Returns true if the required services are unreachable. For some time, other services may run at
/// their addresses and refuse this coordinator.
bool IsAway(const absl::Status& status) {
  return absl::IsUnavailable(status) || absl::IsPermissionDenied(status) ||
         absl::IsUnauthenticated(status);
}

int64_t PauseUs(int32_t times) {
  return std::min(kMaxRetryUs, kFirstRetryUs << std::min(times, 10));
}

/// Returns true if every worker that ran the range died before it could report an error.
bool WorkersDied(const absl::Status& status) {
  const ErrorDetail detail = DetailOf(status);
  if (detail.reason != Reason::kRangePoisoned) return false;
  const auto cause = detail.metadata.find("cause");
  return cause != detail.metadata.end() && cause->second == ReasonName(Reason::kUnavailable);
}

/// Returns true if the server of a stage was lost during a call for the whole job. The run then
/// already repeated the call on another server, which was lost too.
bool CallWasLost(const absl::Status& status) {
  return absl::IsUnavailable(status) && DetailOf(status).metadata.contains("lost");
}

void Fail(const absl::Status& error, const PipelineProgress& reported, JobUpdate& update) {
  update.state = JobState::kFailed;
  update.layers_done = reported.done;
  update.error = JobErrorOf(error);
}

}  // namespace

JobUpdate Conclusion(const JobRecord& job, const LostRuns& lost_runs, const RunRequests& wishes,
                     const absl::Status& error, const PipelineProgress& reported, int64_t now_us) {
  JobUpdate update;
  update.state = JobState::kQueued;
  update.layers_total = reported.total;
  if (wishes.cancelled()) {
    update.state = JobState::kCancelled;
    update.layers_done = reported.done;
  } else if (wishes.handed_back()) {
    update.claimable_from_us = now_us;
  } else if (wishes.Overdue(now_us)) {
    update.state = JobState::kFailed;
    update.layers_done = reported.done;
    update.error = DeadlinePassed();
  } else if (DetailOf(error).reason == Reason::kDiskFull) {
    update.claimable_from_us = now_us + kDiskFullRetryUs;
  } else if (DetailOf(error).reason == Reason::kStoreFailed) {
    // The error does not concern the job, so no number of such errors ends the job.
    update.claimable_from_us = now_us + PauseUs(job.store_failures);
    update.store_failed = true;
  } else if (DetailOf(error).reason == Reason::kOverloaded) {
    // At its next claim, the job waits for memory again.
    update.claimable_from_us = now_us + kNoSpacePauseUs;
  } else if (DetailOf(error).reason == Reason::kBuildMismatch) {
    // An upgrade takes some time and then ends.
    update.claimable_from_us = now_us + kUpgradePauseUs;
  } else if (StageIsAway(error)) {
    // The error does not concern the job. The call has already waited for a server.
    update.claimable_from_us = now_us + kStageAwayPauseUs;
  } else if (DetailOf(error).reason == Reason::kJobPoisoned && !lost_runs.condemned()) {
    update.claimable_from_us = now_us + lost_runs.rest_us();
  } else if (WorkersDied(error) || CallWasLost(error)) {
    if (const auto rest_us = lost_runs.RestAfterDeadlyRunUs()) {
      update.claimable_from_us = now_us + *rest_us;
      update.deadly = true;
    } else {
      Fail(error, reported, update);
    }
  } else if (IsAway(error) && job.retries < kMaxRetries) {
    update.claimable_from_us = now_us + PauseUs(job.retries);
    update.retry = true;
  } else {
    Fail(error, reported, update);
  }
  return update;
}

bool StageIsAway(const absl::Status& error) {
  const ErrorDetail detail = DetailOf(error);
  return absl::IsUnavailable(error) && detail.reason == Reason::kUnavailable &&
         detail.metadata.contains("stage") && !detail.metadata.contains("lost");
}

JobError DeadlinePassed() {
  return JobErrorOf(MakeError(absl::StatusCode::kDeadlineExceeded, Reason::kDeadlineExceeded,
                              "the job's deadline has passed", {{"field", "deadline"}}));
}

}  // namespace slicefarm::coordinator
