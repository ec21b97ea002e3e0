#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "common/stage/memory_budget.h"
#include "common/stage/stages.h"
#include "services/coordinator/server/messages/job_request.h"
#include "services/coordinator/store/blobs/blob_store.h"

namespace slicefarm::coordinator {

/// Reserves memory for the mesh files of a job. Waits until enough memory is free. Errors: see
/// BlobStore::Status and MemoryBudget::Take.
absl::StatusOr<std::unique_ptr<MemoryBudget::Share>> ReserveMeshMemory(const StageCall& call,
                                                                       const ResolvedJob& job,
                                                                       BlobStore& blobs,
                                                                       MemoryBudget& memory);

/// Returns the mesh files of a job and its objects. Errors: see BlobStore::Get.
absl::StatusOr<SliceInput> LoadMeshes(const ResolvedJob& job, BlobStore& blobs);

}  // namespace slicefarm::coordinator
