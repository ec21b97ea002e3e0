#include "services/coordinator/run/run_conclusion.h"

#include <algorithm>

#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kMaxRetries = 5;
constexpr int64_t kFirstRetryUs = 500'000;
constexpr int64_t kNoRoomPauseUs = 1'000'000;
constexpr int64_t kUpgradePauseUs = 5'000'000;
constexpr int64_t kDiskFullRetryUs = 10'000'000;
constexpr int64_t kMaxRetryUs = 60'000'000;

/// True if the services that are needed are not there; for some time there may be others in their
/// places that do not know this coordinator.
bool IsAway(const absl::Status& status) {
  return absl::IsUnavailable(status) || absl::IsPermissionDenied(status) ||
         absl::IsUnauthenticated(status);
}

int64_t PauseUs(int32_t times) {
  return std::min(kMaxRetryUs, kFirstRetryUs << std::min(times, 10));
}

/// True if no worker lived to tell what is wrong with a range.
bool WorkersDied(const absl::Status& status) {
  const ErrorDetail detail = DetailOf(status);
  if (detail.reason != Reason::kRangePoisoned) return false;
  const auto cause = detail.metadata.find("cause");
  return cause != detail.metadata.end() && cause->second == ReasonName(Reason::kUnavailable);
}

/// True if the stage that saw the whole job was not heard of any more: twice in this run already.
bool CallWasLost(const absl::Status& status) {
  return absl::IsUnavailable(status) && DetailOf(status).metadata.contains("lost");
}

void Fail(const absl::Status& error, const PipelineProgress& told, JobUpdate& update) {
  update.state = JobState::kFailed;
  update.layers_done = told.done;
  update.error = JobErrorOf(error);
}

}  // namespace

JobUpdate Conclusion(const JobRecord& job, const LostRuns& lost_runs, const RunWishes& wishes,
                     const absl::Status& error, const PipelineProgress& told, int64_t now_us) {
  JobUpdate update;
  update.state = JobState::kQueued;
  update.layers_total = told.total;
  if (wishes.cancelled()) {
    update.state = JobState::kCancelled;
    update.layers_done = told.done;
  } else if (wishes.handed_back()) {
    update.claimable_from_us = now_us;
  } else if (wishes.Overdue(now_us)) {
    update.state = JobState::kFailed;
    update.layers_done = told.done;
    update.error = DeadlinePassed();
  } else if (DetailOf(error).reason == Reason::kDiskFull) {
    update.claimable_from_us = now_us + kDiskFullRetryUs;
  } else if (DetailOf(error).reason == Reason::kStoreFailed) {
    // Says nothing of the job, so however often it happens, it does not end it.
    update.claimable_from_us = now_us + PauseUs(job.store_failures);
    update.store_failed = true;
  } else if (DetailOf(error).reason == Reason::kOverloaded) {
    update.claimable_from_us = now_us + kNoRoomPauseUs;  // it waits again when it is claimed
  } else if (DetailOf(error).reason == Reason::kBuildMismatch) {
    update.claimable_from_us = now_us + kUpgradePauseUs;  // which takes its time, and ends
  } else if (DetailOf(error).reason == Reason::kJobPoisoned && !lost_runs.condemned()) {
    update.claimable_from_us = now_us + lost_runs.rest_us();
  } else if (WorkersDied(error) || CallWasLost(error)) {
    if (const auto rest_us = lost_runs.RestAfterDeadlyRunUs()) {
      update.claimable_from_us = now_us + *rest_us;
      update.deadly = true;
    } else {
      Fail(error, told, update);
    }
  } else if (IsAway(error) && job.retries < kMaxRetries) {
    update.claimable_from_us = now_us + PauseUs(job.retries);
    update.retry = true;
  } else {
    Fail(error, told, update);
  }
  return update;
}

JobError DeadlinePassed() {
  return JobErrorOf(MakeError(absl::StatusCode::kDeadlineExceeded, Reason::kDeadlineExceeded,
                              "the job's deadline has passed", {{"field", "deadline"}}));
}

}  // namespace slicefarm::coordinator
