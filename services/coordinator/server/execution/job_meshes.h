#pragma once

#include "absl/status/statusor.h"
#include "common/stage/stages.h"
#include "services/coordinator/server/execution/byte_budget.h"
#include "services/coordinator/server/api/job_request.h"
#include "services/coordinator/store/blobs/blob_store.h"

namespace slicefarm::coordinator {

/// Room for the files of a job beside those that others have in memory. Errors: those of
/// BlobStore::Status; `cancel`'s.
absl::StatusOr<ByteBudget::Share> RoomForMeshes(const ResolvedJob& job, BlobStore& blobs,
                                                ByteBudget& memory, const CancelToken& cancel);

/// The files of a job and its objects. Errors: those of BlobStore::Get.
absl::StatusOr<SliceInput> LoadMeshes(const ResolvedJob& job, BlobStore& blobs);

}  // namespace slicefarm::coordinator
