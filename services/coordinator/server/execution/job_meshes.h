#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "common/stage/memory_budget.h"
#include "common/stage/stages.h"
#include "services/coordinator/server/messages/job_request.h"
#include "services/coordinator/store/blobs/blob_store.h"

namespace slicefarm::coordinator {

/// Room for the files of a job beside what others have in memory. Errors: those of
/// BlobStore::Status and MemoryBudget::Take.
absl::StatusOr<std::unique_ptr<MemoryBudget::Share>> RoomForMeshes(const StageCall& call,
                                                                   const ResolvedJob& job,
                                                                   BlobStore& blobs,
                                                                   MemoryBudget& memory);

/// The files of a job and its objects. Errors: those of BlobStore::Get.
absl::StatusOr<SliceInput> LoadMeshes(const ResolvedJob& job, BlobStore& blobs);

}  // namespace slicefarm::coordinator
