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

/// What a run came to, before it is kept.
struct RunOutput {
  SpooledText program;
  std::string report_json;
  JobResult result;  ///< without digests, size and cost
};

/// Whether tenants take each other's results for the same work. It shows: a result that is there at
/// once tells that somebody has sliced this mesh before.
enum class ResultSharing { kOff, kOn };

/// Whose results a tenant's jobs take and leave: its own, or everybody's, which go without a name.
inline std::string ResultTenant(ResultSharing sharing, const std::string& tenant) {
  return sharing == ResultSharing::kOn ? "" : tenant;
}

/// Results of jobs: record and blobs together, so that no job refers to a blob that is not there.
/// Blobs that nothing refers to are left to BlobSweep, which spares those that were just written.
class JobResults {
 public:
  JobResults(JobStore& jobs, BlobStores& blobs, Rates rates)
      : jobs_(jobs), blobs_(blobs), rates_(std::move(rates)) {}

  /// Keeps the artifacts among the tenant's blobs; what is left is to write the update, which ends
  /// the job as SUCCEEDED. Errors: those of the blob store.
  absl::StatusOr<JobUpdate> Keep(const ResolvedJob& job, const RunOutput& output,
                                 const std::string& result_tenant);

  /// Ends the job with the result that the same work came to before, at today's rates. nullopt:
  /// there is none, or its blobs are gone.
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
