#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/base/spooled_text.h"
#include "services/coordinator/algo/pipeline/cost.h"
#include "services/coordinator/server/messages/job_request.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_store.h"

namespace slicefarm::coordinator {

/// Result of a run before it is stored.
struct RunOutput {
  SpooledText program;
  std::string report_json;
  JobResult result;  ///< without digests, size and cost
};

/// Selects whether a tenant gets results that were computed for another tenant's equal work.
/// Tenants can notice this: an immediate result reveals that another tenant has sliced this mesh
/// before.
enum class ResultSharing { kOff, kOn };

/// Returns the tenant under which a job's results are stored and searched. With sharing, this is
/// the empty name for every tenant.
inline std::string ResultTenant(ResultSharing sharing, const std::string& tenant) {
  return sharing == ResultSharing::kOn ? "" : tenant;
}

/// Results of jobs. Stores the record and its blobs together, so that no job refers to a missing
/// blob. Blobs without a referring job are removed by BlobSweep, which spares newly written blobs.
class JobResults {
 public:
  JobResults(JobStore& jobs, BlobStores& blobs, Rates rates)
      : jobs_(jobs), blobs_(blobs), rates_(std::move(rates)) {}

  /// Stores the artifacts as blobs of the tenant `result_tenant`. Returns the update that ends the
  /// job as SUCCEEDED; the caller must write it. Errors: see BlobStore.
  absl::StatusOr<JobUpdate> Keep(const ResolvedJob& job, const RunOutput& output,
                                 const std::string& result_tenant);

  /// Ends the job with the stored result of the same work. The cost is computed by the current
  /// rates. Returns nullopt if there is no stored result or if its blobs are missing. Errors: see
  /// JobStore.
  absl::StatusOr<std::optional<JobRecord>> SucceedFromCache(const Lease& lease,
                                                            const ResolvedJob& job, int64_t now_us);

 private:
  absl::StatusOr<std::optional<JobResult>> Find(const ResolvedJob& job);
  absl::StatusOr<bool> Complete(const JobResult& result);
  Cost CostOfJob(const ResolvedJob& job, const JobResult& result) const;

  JobStore& jobs_;
  BlobStores& blobs_;
  const Rates rates_;
};

}  // namespace slicefarm::coordinator
