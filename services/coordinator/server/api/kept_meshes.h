#pragma once

#include <cstdint>
#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// The tenant's meshes and uploads with names after `after`, `size` at most, by their names. Left
/// out is what jobs came to; of what jobs that were deleted came to, it is not known until it is
/// swept. Cost: reads the list of the tenant's blobs. Errors: the stores'.
absl::StatusOr<v1::ListMeshesResponse> MeshesAfter(BlobStore& blobs, JobStore& jobs,
                                                   const std::string& tenant,
                                                   const std::string& after, int32_t size);

/// False: a job refers to it, or there is none. Errors: REQUEST_MALFORMED for a name that is no
/// digest; the stores'.
absl::StatusOr<bool> DeleteUnlessUsed(BlobStore& blobs, JobStore& jobs, const std::string& tenant,
                                      const std::string& digest);

/// A project whose plate of this number (0: the only one) has its spec, and the others none, which
/// may be a MiB each. Errors: REQUEST_MALFORMED for a plate that it does not have;
/// REQUEST_TOO_LARGE for a spec that no job may have.
absl::StatusOr<v1::ReadProjectResponse> WithSpecOf(int32_t plate, v1::ReadProjectResponse project);

}  // namespace slicefarm::coordinator
