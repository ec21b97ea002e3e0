#include "services/coordinator/server/api/artifact.h"

#include <fmt/core.h>

#include "common/base/error.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm::coordinator {
namespace {

absl::Status IsAQuote(const std::string& id) {
  return MakeError(absl::StatusCode::kNotFound, Reason::kBlobNotFound,
                   fmt::format("job {} is a quote: it has a report, but no G-code", id),
                   {{"job", id}});
}

/// Returns the error of a job without a result. A job that was cancelled or failed gets an error of
/// its own, because a client would otherwise wait for it forever.
absl::Status HasNoResult(const JobRecord& job) {
  Reason reason = Reason::kJobNotFinished;
  if (job.state == JobState::kCancelled) reason = Reason::kCancelled;
  if (job.state == JobState::kFailed && job.error)
    reason = ReasonFromName(job.error->reason).value_or(Reason::kInternal);
  return MakeError(absl::StatusCode::kFailedPrecondition, reason,
                   fmt::format("job {} has no result: it is {}", job.id, JobStateName(job.state)),
                   {{"job", job.id}, {"state", std::string(JobStateName(job.state))}});
}

}  // namespace

absl::StatusOr<std::string> ArtifactOf(const JobRecord& job, v1::Artifact artifact) {
  if (!job.result) return HasNoResult(job);
  switch (artifact) {
    case v1::ARTIFACT_GCODE:
      if (job.result->gcode_sha256.empty()) return IsAQuote(job.id);
      return job.result->gcode_sha256;
    case v1::ARTIFACT_REPORT:
      return job.result->report_sha256;
    default:
      return Malformed("artifact", "has a value that this version does not know");
  }
}

}  // namespace slicefarm::coordinator
