#pragma once

#include <string>

#include "common/base/span_log.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// What was done for jobs, and when: a blob of its tenant's for each job that was computed, which
/// grows with each run that comes to an end. What a coordinator did that was killed is not in it.
class JobTraces {
 public:
  JobTraces(JobStore& jobs, BlobStores& blobs) : jobs_(jobs), blobs_(blobs) {}

  /// Keeps what earlier runs of the job did, and this one: its spans and the run as a whole.
  /// Returns the blob's name, for the job's record. Errors: the blob store's.
  absl::StatusOr<std::string> Keep(const JobRecord& job, const SpanLog& run, Span whole);

  /// All of it, and when the job waited, as ChromeTrace writes it; of a job that was answered from
  /// the cache, the waiting only. Errors: JOB_NOT_FINISHED; the stores'.
  absl::StatusOr<std::string> Chrome(const JobRecord& job);

 private:
  JobStore& jobs_;
  BlobStores& blobs_;
};

}  // namespace slicefarm::coordinator
