#include "services/coordinator/server/job_meshes.h"

#include <utility>

namespace slicefarm::coordinator {

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
