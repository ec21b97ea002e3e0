#include "services/coordinator/store/jobs/job_steps.h"

#include <fmt/core.h>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator {
namespace {

void LetGo(JobRecord& job, int64_t claimable_from_us) {
  job.owner.clear();
  job.owner_until_us = claimable_from_us;
}

}  // namespace

absl::Status ApplyUpdate(JobRecord& job, const Lease& lease, const JobUpdate& update,
                         int64_t now_us) {
  if (job.owner_epoch != lease.epoch || job.owner.empty() || IsTerminal(job.state)) {
    return NotHeld(lease);
  }
  // The owner did not learn of the cancel request in time, and returns the job to the queue or ends
  // it. The job is cancelled instead: no coordinator needs to finish it, and a client that was
  // promised a cancellation gets no print.
  const bool ends = job.cancel_requested &&
                    (update.state == JobState::kQueued || update.state == JobState::kSucceeded);
  const JobState to = ends ? JobState::kCancelled : update.state;
  const bool begins = job.state == JobState::kQueued && to == JobState::kRunning;
  if (to != job.state && !MayFollow(job.state, to)) {
    return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                     fmt::format("job {} cannot go from {} to {}", job.id, JobStateName(job.state),
                                 JobStateName(to)));
  }
  job.state = to;
  job.layers_total = update.layers_total;
  job.layers_done = update.layers_done;
  job.error = update.error;
  if (!ends) job.result = update.result;
  if (!update.trace_sha256.empty()) job.trace_sha256 = update.trace_sha256;
  if (update.retry) ++job.retries;
  if (update.store_failed) ++job.store_failures;
  if (update.deadly) ++job.deadly_runs;
  job.lost_runs = update.lost_runs;
  if (begins && job.start_us == 0) job.start_us = now_us;
  if (IsTerminal(job.state)) job.end_us = now_us;
  if (IsTerminal(job.state)) LetGo(job, 0);
  if (job.state == JobState::kQueued) LetGo(job, update.claimable_from_us);
  return absl::OkStatus();
}

bool ApplyCancel(JobRecord& job, int64_t now_us) {
  if (IsTerminal(job.state)) return false;
  const bool at_once = job.state == JobState::kQueued && job.owner.empty();
  // The owner that was to end the job may have died meanwhile and released the job.
  if (job.cancel_requested && !at_once) return false;
  job.cancel_requested = true;
  if (!at_once) return true;
  job.state = JobState::kCancelled;
  job.end_us = now_us;
  ++job.owner_epoch;
  LetGo(job, 0);
  return true;
}

void ApplyChange(JobRecord& job, const JobChanging& changing) {
  if (changing.labels) job.labels = *changing.labels;
  if (IsTerminal(job.state)) return;
  if (changing.priority) job.priority = *changing.priority;
  if (changing.deadline_us) job.deadline_us = *changing.deadline_us;
}

bool ApplyOverdue(JobRecord& job, const JobError& error, int64_t now_us) {
  const bool held = !job.owner.empty() && job.owner_until_us > now_us;
  const bool waits = !IsTerminal(job.state) && !held && !job.cancel_requested;
  if (!waits || job.deadline_us > now_us) return false;
  job.state = JobState::kFailed;
  job.error = error;
  job.end_us = now_us;
  ++job.owner_epoch;
  LetGo(job, 0);
  return true;
}

absl::Status NotHeld(const Lease& lease) {
  return absl::AbortedError(
      absl::StrCat("job ", lease.job_id, " is not held in epoch ", lease.epoch));
}

absl::Status JobNotFound(const std::string& id) {
  return MakeError(absl::StatusCode::kNotFound, Reason::kJobNotFound,
                   absl::StrCat("there is no job ", id), {{"job", id}});
}

absl::Status JobNotFinished(const std::string& id) {
  return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kJobNotFinished,
                   absl::StrCat("job ", id, " has not ended"), {{"job", id}});
}

absl::Status CachedResultGone(const std::string& id) {
  return MakeError(absl::StatusCode::kNotFound, Reason::kBlobNotFound,
                   absl::StrCat("the cached result for job ", id, " was deleted meanwhile"));
}

absl::Status RequestIdReused(const std::string& request_id) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestIdReused,
                   absl::StrCat("request_id ", request_id, " was used for another job"),
                   {{"request_id", request_id}});
}

absl::Status QueueFull(int64_t limit) {
  return MakeError(absl::StatusCode::kResourceExhausted, Reason::kQueueFull,
                   absl::StrCat("there are ", limit, " jobs already that have not ended"),
                   {{"limit", absl::StrCat(limit)}, {rpc::kRetryAfterMs, "5000"}});
}

}  // namespace slicefarm::coordinator
