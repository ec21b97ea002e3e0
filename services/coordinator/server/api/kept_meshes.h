#pragma once

#include <cstdint>
#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Returns at most `size` meshes and uploads of the tenant, sorted by name, with names after
/// `after`. Results of jobs are left out. Results of deleted jobs cannot be recognized until they
/// are swept. Cost: reads the list of the tenant's blobs. Errors: errors of the stores.
absl::StatusOr<v1::ListMeshesResponse> MeshesAfter(BlobStore& blobs, JobStore& jobs,
                                                   const std::string& tenant,
                                                   const std::string& after, int32_t size);

/// Deletes a mesh. Returns false if a job refers to it or if it does not exist. Errors:
/// REQUEST_MALFORMED for a name that is no digest; errors of the stores.
absl::StatusOr<bool> DeleteUnlessUsed(BlobStore& blobs, JobStore& jobs, const std::string& tenant,
                                      const std::string& digest);

/// Returns the project with the spec of only one plate, because each spec may have a MiB. `plate`:
/// its number; 0: the only plate. Errors: REQUEST_MALFORMED if the project has no such plate;
/// REQUEST_TOO_LARGE if the spec is too large for a job.
absl::StatusOr<v1::ReadProjectResponse> WithSpecOf(int32_t plate, v1::ReadProjectResponse project);

}  // namespace slicefarm::coordinator
