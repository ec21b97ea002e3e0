#pragma once

#include <optional>
#include <string>

#include "services/coordinator/store/blob_store.h"
#include "services/coordinator/store/job_store.h"

namespace slicefarm::coordinator {

/// What a run came to, before it is kept.
struct RunOutput {
  std::string gcode;
  std::string report_json;
  JobResult result;  ///< without digests and size
};

/// Results of jobs: record and blobs together, so that no job refers to a blob that is not there.
/// Blobs that nothing refers to are left to BlobSweep, which spares those that were just written.
class JobResults {
 public:
  JobResults(JobStore& jobs, BlobStore& blobs) : jobs_(jobs), blobs_(blobs) {}

  /// Keeps the artifacts and ends the job as SUCCEEDED. Errors: those of both stores.
  absl::StatusOr<JobRecord> Succeed(const Lease& lease, RunOutput output, int64_t now_us);

  /// Ends the job with the result that the same work came to before. nullopt: there is none, or its
  /// blobs are gone.
  absl::StatusOr<std::optional<JobRecord>> SucceedFromCache(const Lease& lease,
                                                            const std::string& action_digest,
                                                            int64_t now_us);

 private:
  absl::StatusOr<bool> Complete(const JobResult& result);

  JobStore& jobs_;
  BlobStore& blobs_;
};

}  // namespace slicefarm::coordinator
