#pragma once

#include <cstdint>
#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/jobs/job_store.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Returns a page of the tenant's meshes and uploads, sorted by name: at most `size`, with names
/// after `after`. Results of jobs are not included. Results of deleted jobs are, until the sweep
/// removes them, because they cannot be distinguished from meshes. Cost: reads the list of the
/// tenant's blobs. Errors: see BlobStore and JobStore.
absl::StatusOr<v1::ListMeshesResponse> MeshesAfter(BlobStore& blobs, JobStore& jobs,
                                                   const std::string& tenant,
                                                   const std::string& after, int32_t size);

/// Deletes a mesh. Returns false if a job refers to it or if it does not exist. Errors:
/// REQUEST_MALFORMED for a name that is no digest; see BlobStore and JobStore.
absl::StatusOr<bool> DeleteUnlessUsed(BlobStore& blobs, JobStore& jobs, const std::string& tenant,
                                      const std::string& digest);

/// Returns the project without the specs of all plates except one, because each spec may have a
/// MiB. `plate`: number of the plate that keeps its spec; 0: the project's only plate. Errors:
/// REQUEST_MALFORMED if the project has no such plate; REQUEST_TOO_LARGE if the spec is too large
/// for a job.
absl::StatusOr<v1::ReadProjectResponse> WithSpecOf(int32_t plate, v1::ReadProjectResponse project);

}  // namespace slicefarm::coordinator
