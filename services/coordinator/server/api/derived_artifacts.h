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

/// What is not kept, but read from a job's program when somebody asks for it.
bool IsDerived(v1::Artifact artifact);

/// The bytes of ARTIFACT_LAYERS or ARTIFACT_THUMBNAIL. Errors: those of ArtifactOf; BLOB_NOT_FOUND
/// if the program has none; the blob store's; CANCELLED in a CancelScope.
absl::StatusOr<std::string> Derive(const JobRecord& job, v1::Artifact artifact, BlobStores& blobs);

/// Those of a job that has a result; without its trace. Cost: reads the program if `facts` does not
/// know what is derived of it. Errors: JOB_NOT_FINISHED; the blob store's; CANCELLED in a
/// CancelScope.
absl::StatusOr<v1::ListArtifactsResponse> ListArtifacts(const JobRecord& job, BlobStores& blobs,
                                                        DerivedFacts& facts);

}  // namespace slicefarm::coordinator
