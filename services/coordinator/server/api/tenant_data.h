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

/// Stores with all data of a tenant. They must outlive this object.
struct TenantData {
  JobStore& jobs;
  BlobStores& blobs;
  ProfileStore& profiles;
  ProfileStore& preset_bundles;
};

/// Function that takes bytes. Returns false if the receiver wants no more.
using TakeBytes = std::function<bool(std::string_view)>;

/// Writes a tar archive: `jobs/ID.json`, `blobs/SHA256` (meshes and results of the jobs, and
/// complete uploads), `profiles/NUMBER-REVISION.json`, `presets/NUMBER-REVISION.json`, and
/// `not-readable.txt` with the names of damaged blobs. Data that is added or deleted meanwhile may
/// be missing. Cost: reads all data; one piece at a time is in memory. Errors: see JobStore,
/// BlobStore and ProfileStore; CANCELLED.
absl::Status ExportTenant(const std::string& tenant, const TenantData& data, int64_t now_us,
                          const CancelToken& cancel, const TakeBytes& take);

/// Erases a tenant. Cancels its open jobs (calls `cancelled` for each), waits for their ends, and
/// removes all data. Blobs that are results of other tenants' jobs stay. Errors: see JobStore,
/// BlobStore and ProfileStore; CANCELLED. After an error, a second call continues.
absl::StatusOr<v1::EraseTenantResponse> EraseTenant(
    const std::string& tenant, const TenantData& data, const std::function<int64_t()>& now_us,
    const CancelToken& cancel, const std::function<void(const std::string& job)>& cancelled);

}  // namespace slicefarm::coordinator
