#include "services/coordinator/server/execution/job_meshes.h"

#include <utility>

namespace slicefarm::coordinator {

absl::StatusOr<ByteBudget::Share> RoomForMeshes(const JobRequest& request, BlobStore& blobs,
                                                ByteBudget& memory, const CancelToken& cancel) {
  int64_t bytes = 0;
  for (const ObjectRequest& object : request.objects) {
    const auto mesh = blobs.Status(object.mesh_sha256);
    if (!mesh.ok()) return mesh.status();
    bytes += mesh->committed_size;
  }
  return memory.Take(bytes, cancel);
}

absl::StatusOr<SliceInput> LoadMeshes(const JobRequest& request, BlobStore& blobs) {
  SliceInput input;
  for (const ObjectRequest& object : request.objects) {
    auto bytes = blobs.Get(object.mesh_sha256);
    if (!bytes.ok()) return bytes.status();
    input.files.push_back({object.name, object.format, *std::move(bytes)});
    input.placements.push_back(object.placement);
  }
  return input;
}

}  // namespace slicefarm::coordinator
