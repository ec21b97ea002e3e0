#pragma once

#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/server/api/derived_facts.h"
#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/jobs/job_record.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Returns true if the artifact is not stored but read from a job's program on request.
bool IsDerived(v1::Artifact artifact);

/// Returns the bytes of ARTIFACT_LAYERS or ARTIFACT_THUMBNAIL. Errors: see ArtifactOf;
/// BLOB_NOT_FOUND if the program has no layer comments or no thumbnail; see BlobStore; CANCELLED in
/// a CancelScope.
absl::StatusOr<std::string> Derive(const JobRecord& job, v1::Artifact artifact, BlobStores& blobs);

/// Returns the artifacts of a job that has a result, except its trace. Cost: reads the program if
/// `facts` does not have the sizes of its derived artifacts. Errors: JOB_NOT_FINISHED; see
/// BlobStore; CANCELLED in a CancelScope.
absl::StatusOr<v1::ListArtifactsResponse> ListArtifacts(const JobRecord& job, BlobStores& blobs,
                                                        DerivedFacts& facts);

}  // namespace slicefarm::coordinator
