#pragma once

#include <string>

#include "common/base/span_log.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Stored traces of jobs. The trace of a computed job is a blob of its tenant, which grows with
/// each run that ends. The runs of a coordinator that was killed are missing.
class JobTraces {
 public:
  JobTraces(JobStore& jobs, BlobStores& blobs) : jobs_(jobs), blobs_(blobs) {}

  /// Stores the trace of earlier runs together with this run: its spans, and `whole` for the run as
  /// a whole. Returns the blob's name for the job's record. Errors: errors of the blob store.
  absl::StatusOr<std::string> Keep(const JobRecord& job, const SpanLog& run, Span whole);

  /// Returns the whole trace and the job's waiting times in the format of ChromeTrace. For a job
  /// with a cached result, returns only the waiting times. Errors: JOB_NOT_FINISHED; errors of the
  /// stores.
  absl::StatusOr<std::string> Chrome(const JobRecord& job);

 private:
  JobStore& jobs_;
  BlobStores& blobs_;
};

}  // namespace slicefarm::coordinator
