#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/store/jobs/job_record.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Returns the digest of the blob that stores an artifact of the job. Errors: JOB_NOT_FINISHED;
/// BLOB_NOT_FOUND for the G-code of a quote; REQUEST_MALFORMED for an artifact that is not stored.
absl::StatusOr<std::string> ArtifactOf(const JobRecord& job, v1::Artifact artifact);

}  // namespace slicefarm::coordinator
