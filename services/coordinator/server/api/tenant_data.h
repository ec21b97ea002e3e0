#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// All that a farm keeps of a tenant. Everything outlives it.
struct TenantData {
  JobStore& jobs;
  BlobStores& blobs;
  ProfileStore& profiles;
};

/// Takes bytes; false: nobody wants more.
using TakeBytes = std::function<bool(std::string_view)>;

/// Writes a tar archive: `jobs/ID.json`, `blobs/SHA256` (the meshes and results that the jobs name,
/// and complete uploads), `profiles/NUMBER-REVISION.json`, and `not-readable.txt` with what is
/// damaged. What comes or goes meanwhile may be missing. Cost: reads all of it; holds a piece at a
/// time. Errors: the stores'; CANCELLED.
absl::Status ExportTenant(const std::string& tenant, const TenantData& data, int64_t now_us,
                          const CancelToken& cancel, const TakeBytes& take);

/// Cancels the tenant's open jobs (`cancelled` is told of each), waits for their end, and removes
/// all that is kept; blobs that jobs of others have as results stay. Errors: the stores';
/// CANCELLED, after which a second call goes on.
absl::StatusOr<v1::EraseTenantResponse> EraseTenant(
    const std::string& tenant, const TenantData& data, const std::function<int64_t()>& now_us,
    const CancelToken& cancel, const std::function<void(const std::string& job)>& cancelled);

}  // namespace slicefarm::coordinator
