#pragma once

#include "absl/status/statusor.h"
#include "common/stage/stages.h"
#include "services/coordinator/server/job_request.h"
#include "services/coordinator/store/blob_store.h"

namespace slicefarm::coordinator {

/// The files of a job with their places on the bed. Errors: those of BlobStore::Get.
absl::StatusOr<SliceInput> LoadMeshes(const JobRequest& request, BlobStore& blobs);

}  // namespace slicefarm::coordinator
