#pragma once

#include <optional>
#include <string>

#include "services/coordinator/store/blob_stores.h"
#include "services/coordinator/store/job_store.h"

namespace slicefarm::coordinator {

/// What a run came to, before it is kept.
struct RunOutput {
  std::string gcode;
  std::string report_json;
  JobResult result;  ///< without digests and size
};

/// Whether tenants take each other's results for the same work. It shows: a result that is there at
/// once tells that somebody has sliced this mesh before.
enum class ResultSharing { kOff, kOn };

/// Whose results a tenant's jobs take and leave: his own, or everybody's, which go without a name.
inline std::string ResultTenant(ResultSharing sharing, const std::string& tenant) {
  return sharing == ResultSharing::kOn ? "" : tenant;
}

/// Results of jobs: record and blobs together, so that no job refers to a blob that is not there.
/// Blobs that nothing refers to are left to BlobSweep, which spares those that were just written.
class JobResults {
 public:
  JobResults(JobStore& jobs, BlobStores& blobs) : jobs_(jobs), blobs_(blobs) {}

  /// Keeps the artifacts among the tenant's blobs and ends the job as SUCCEEDED. Errors: those of
  /// both stores.
  absl::StatusOr<JobRecord> Succeed(const Lease& lease, RunOutput output,
                                    const std::string& result_tenant, int64_t now_us);

  /// Ends the job with the result that the same work came to before. nullopt: there is none, or its
  /// blobs are gone.
  absl::StatusOr<std::optional<JobRecord>> SucceedFromCache(const Lease& lease,
                                                            const std::string& action_digest,
                                                            int64_t now_us);

 private:
  absl::StatusOr<bool> Complete(const JobResult& result);

  JobStore& jobs_;
  BlobStores& blobs_;
};

}  // namespace slicefarm::coordinator
