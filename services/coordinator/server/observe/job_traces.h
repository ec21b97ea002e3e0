#pragma once

#include <string>

#include "common/base/span_log.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Stored traces of jobs. The trace of a job is a blob of its tenant, to which each run that ends
/// adds its spans. Runs of a coordinator that was killed are missing.
class JobTraces {
 public:
  JobTraces(JobStore& jobs, BlobStores& blobs) : jobs_(jobs), blobs_(blobs) {}

  /// Adds the spans of this run, and `whole` for the run as a whole, to the job's stored trace.
  /// Stores the result and returns the blob's digest for the job's record. Errors: see BlobStore.
  absl::StatusOr<std::string> Keep(const JobRecord& job, const SpanLog& run, Span whole);

  /// Returns the whole trace and the job's waiting times in the format of ChromeTrace. For a job
  /// with a cached result, returns only the waiting times. Errors: JOB_NOT_FINISHED; see JobStore
  /// and BlobStore.
  absl::StatusOr<std::string> Chrome(const JobRecord& job);

 private:
  JobStore& jobs_;
  BlobStores& blobs_;
};

}  // namespace slicefarm::coordinator
