#include "services/cli/farm/job_outcome.h"

#include <fmt/core.h>

#include "common/base/error.h"

namespace slicefarm::cli {

bool HasEnded(const v1::Job& job) {
  return job.state() == v1::JOB_STATE_SUCCEEDED || job.state() == v1::JOB_STATE_FAILED ||
         job.state() == v1::JOB_STATE_CANCELLED;
}

absl::Status OutcomeOf(const v1::Job& job) {
  if (job.state() == v1::JOB_STATE_SUCCEEDED) return absl::OkStatus();
  if (job.state() == v1::JOB_STATE_CANCELLED) {
    return MakeError(absl::StatusCode::kCancelled, Reason::kCancelled,
                     fmt::format("job {} was cancelled", job.id()));
  }
  if (job.state() != v1::JOB_STATE_FAILED) {
    return MakeError(absl::StatusCode::kFailedPrecondition, Reason::kJobNotFinished,
                     fmt::format("job {} is not finished", job.id()));
  }
  const v1::JobError& error = job.error();
  const int code = error.code() == 0 ? static_cast<int>(absl::StatusCode::kUnknown) : error.code();
  return MakeError(static_cast<absl::StatusCode>(code),
                   ReasonFromName(error.reason()).value_or(Reason::kInternal), error.message(),
                   {error.metadata().begin(), error.metadata().end()});
}

}  // namespace slicefarm::cli
