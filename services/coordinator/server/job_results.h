#pragma once

#include <shared_mutex>
#include <string>
#include <vector>

#include "services/coordinator/store/blob_store.h"
#include "services/coordinator/store/job_store.h"

namespace slicefarm::coordinator {

/// What a run came to, before it is kept.
struct RunOutput {
  std::string gcode;
  std::string report_json;
  JobResult result;  ///< without digests and size
};

/// Results of jobs: record and blobs together, so that no job refers to a blob that is not there. A
/// deletion waits for results that are being written, and the other way round.
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

  /// Removes an ended job, and the blobs that were its alone.
  absl::Status Delete(const std::string& job_id);

 private:
  absl::StatusOr<bool> Complete(const JobResult& result);

  JobStore& jobs_;
  BlobStore& blobs_;
  std::shared_mutex mutex_;  ///< exclusive: deletions
};

}  // namespace slicefarm::coordinator
