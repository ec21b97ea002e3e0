#include "services/coordinator/server/api/kept_meshes.h"

#include <fmt/core.h>

#include <map>
#include <set>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm::coordinator {
namespace {

/// Collects the first `most` blobs by name.
class FirstBlobs {
 public:
  FirstBlobs(std::string after, size_t most) : after_(std::move(after)), most_(most) {}

  void Take(const BlobEntry& blob) {
    if (blob.digest <= after_) return;
    blobs_.emplace(blob.digest, blob);
    if (blobs_.size() > most_) blobs_.erase(std::prev(blobs_.end()));
  }
  const std::map<std::string, BlobEntry>& blobs() const { return blobs_; }

 private:
  const std::string after_;
  const size_t most_;
  std::map<std::string, BlobEntry> blobs_;
};

}  // namespace

absl::StatusOr<v1::ListMeshesResponse> MeshesAfter(BlobStore& blobs, JobStore& jobs,
                                                   const std::string& tenant,
                                                   const std::string& after, int32_t size) {
  FirstBlobs first(after, static_cast<size_t>(size) + 1);
  const absl::Status seen = blobs.ForEach([&](const BlobEntry& blob) { first.Take(blob); });
  if (!seen.ok()) return seen;
  std::set<std::string> digests;
  for (const auto& [digest, blob] : first.blobs()) digests.insert(digest);
  const auto artifacts = jobs.Artifacts(tenant, digests);
  if (!artifacts.ok()) return artifacts.status();
  v1::ListMeshesResponse page;
  int32_t left = size;
  for (const auto& [digest, blob] : first.blobs()) {
    if (left-- == 0) break;
    page.set_next_page_token(digest);
    if (artifacts->contains(digest)) continue;
    v1::ListMeshesResponse::Mesh& mesh = *page.add_meshes();
    mesh.set_sha256(digest);
    mesh.set_size(blob.size);
    mesh.set_complete(blob.complete);
    mesh.set_idle_s(static_cast<int64_t>(blob.idle_s));
  }
  if (std::ssize(first.blobs()) <= size) page.clear_next_page_token();
  return page;
}

absl::StatusOr<bool> DeleteUnlessUsed(BlobStore& blobs, JobStore& jobs, const std::string& tenant,
                                      const std::string& digest) {
  const auto status = blobs.Status(digest);
  if (!status.ok()) return status.status();
  const auto used = jobs.Referenced(tenant, {digest});
  if (!used.ok()) return used.status();
  if (used->contains(digest)) return false;
  // A job that is created with this mesh at this moment has used the mesh within this time.
  constexpr double kJustUsedS = 2;
  return blobs.Delete(digest, kJustUsedS);
}

absl::StatusOr<v1::ReadProjectResponse> WithSpecOf(int32_t plate, v1::ReadProjectResponse project) {
  bool found = plate == 0;
  for (v1::ReadProjectResponse::Plate& each : *project.mutable_plates()) {
    const bool wanted = plate == 0 ? project.plates_size() == 1 : each.number() == plate;
    found = found || wanted;
    if (!wanted) {
      each.clear_spec();
      continue;
    }
    const auto bytes = static_cast<int64_t>(each.spec().ByteSizeLong());
    if (bytes > limits::kMaxSpecBytes)
      return LimitError(Reason::kRequestTooLarge, "bytes of a spec", limits::kMaxSpecBytes, bytes);
  }
  if (!found) {
    return Malformed("plate", fmt::format("is not one of the {} plates with objects to print",
                                          project.plates_size()));
  }
  return project;
}

}  // namespace slicefarm::coordinator
