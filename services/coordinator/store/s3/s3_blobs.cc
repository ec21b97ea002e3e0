#include "services/coordinator/store/s3/s3_blobs.h"

#include <set>

namespace slicefarm::coordinator {

absl::StatusOr<std::shared_ptr<S3BlobStore>> S3Blobs::StoreOf(const std::string& tenant) {
  auto staged = staged_->Of(tenant);  // also checks the name
  if (!staged.ok()) return staged.status();
  const std::lock_guard lock(mutex_);
  std::shared_ptr<S3BlobStore>& store = stores_[tenant];
  if (store == nullptr)
    store = std::make_shared<S3BlobStore>(bucket_, database_, *std::move(staged), tenant);
  return store;
}

absl::StatusOr<std::shared_ptr<BlobStore>> S3Blobs::Of(const std::string& tenant) {
  return StoreOf(tenant);
}

absl::StatusOr<std::vector<std::string>> S3Blobs::Tenants() {
  const auto here = S3Index::Tenants(*database_);
  if (!here.ok()) return here;
  const auto staged = staged_->Tenants();
  if (!staged.ok()) return staged;
  std::set<std::string> all(here->begin(), here->end());
  all.insert(staged->begin(), staged->end());
  return std::vector<std::string>(all.begin(), all.end());
}

absl::Status S3Blobs::MoveStaged(const std::function<void(const BlobEntry&)>& moved) {
  const auto tenants = staged_->Tenants();
  if (!tenants.ok()) return tenants.status();
  for (const std::string& tenant : *tenants) {
    const auto store = StoreOf(tenant);
    if (!store.ok()) return store.status();
    if (absl::Status moved_all = (*store)->MoveStaged(moved); !moved_all.ok()) return moved_all;
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
