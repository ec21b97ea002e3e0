#include "services/coordinator/server/execution/job_meshes.h"

#include <utility>

namespace slicefarm::coordinator {

absl::StatusOr<std::unique_ptr<MemoryBudget::Share>> ReserveMeshMemory(const StageCall& call,
                                                                       const ResolvedJob& job,
                                                                       BlobStore& blobs,
                                                                       MemoryBudget& memory) {
  int64_t bytes = 0;
  for (const StoredMesh& mesh : job.request.scene.meshes) {
    const auto status = blobs.Status(mesh.sha256);
    if (!status.ok()) return status.status();
    bytes += status->committed_size;
  }
  return memory.Take(call.claimant, call.job_id, bytes, call.cancel);
}

absl::StatusOr<SliceInput> LoadMeshes(const ResolvedJob& job, BlobStore& blobs) {
  SliceInput input;
  for (const StoredMesh& mesh : job.request.scene.meshes) {
    auto bytes = blobs.Get(mesh.sha256);
    if (!bytes.ok()) return bytes.status();
    input.files.push_back({mesh.name, mesh.format, *std::move(bytes)});
  }
  input.objects = job.plate.objects;
  return input;
}

}  // namespace slicefarm::coordinator
