#include "services/coordinator/store/blobs/blob_stores.h"

#include <filesystem>
#include <map>
#include <mutex>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "services/coordinator/algo/tenants.h"
#include "services/coordinator/store/blobs/directory_blob_store.h"
#include "services/coordinator/store/blobs/postgres_blob_store.h"

namespace slicefarm::coordinator {
namespace {

/// Checks a tenant's name here as well, because it becomes part of a path.
absl::Status CheckTenant(const std::string& tenant) {
  if (tenant.empty() || IsTenantName(tenant)) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   "a tenant's name must be 1 to 63 characters of a-z, 0-9, '-' and '_'");
}

class DirectoryBlobs : public BlobStores {
 public:
  explicit DirectoryBlobs(std::string root) : root_(std::move(root)) {}

  /// Returns the tenant's store. There is one store object per directory, because all its users
  /// must share the object's locks.
  absl::StatusOr<std::shared_ptr<BlobStore>> Of(const std::string& tenant) override {
    if (absl::Status named = CheckTenant(tenant); !named.ok()) return named;
    const std::lock_guard lock(mutex_);
    std::shared_ptr<BlobStore>& store = stores_[tenant];
    if (store == nullptr) {
      auto opened = DirectoryBlobStore::OpenAt(
          tenant.empty() ? root_ : absl::StrCat(root_, "/tenants/", tenant));
      if (!opened.ok()) return opened.status();
      store = *std::move(opened);
    }
    return store;
  }

  absl::StatusOr<std::vector<std::string>> Tenants() override {
    std::vector<std::string> tenants = {""};
    std::error_code error;
    std::filesystem::directory_iterator entries(root_ + "/tenants", error);
    if (error == std::errc::no_such_file_or_directory) return tenants;
    for (; !error && entries != std::filesystem::directory_iterator(); entries.increment(error)) {
      std::string name = entries->path().filename();
      if (IsTenantName(name)) tenants.push_back(std::move(name));
    }
    if (!error) return tenants;
    return MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed,
                     absl::StrCat("list ", root_, ": ", error.message()));
  }

 private:
  const std::string root_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<BlobStore>> stores_;  // shared with calls in flight
};

class PostgresBlobs : public BlobStores {
 public:
  explicit PostgresBlobs(std::shared_ptr<SqlDatabase> database) : database_(std::move(database)) {}

  absl::StatusOr<std::shared_ptr<BlobStore>> Of(const std::string& tenant) override {
    if (absl::Status named = CheckTenant(tenant); !named.ok()) return named;
    return std::make_shared<PostgresBlobStore>(database_, tenant);
  }

  absl::StatusOr<std::vector<std::string>> Tenants() override {
    const auto session = database_->Read();
    if (!session.ok()) return session.status();
    SqlQuery query(**session, "SELECT DISTINCT tenant FROM blobs WHERE tenant <> ''");
    std::vector<std::string> tenants = {""};
    while (query.Next()) tenants.push_back(query.Text(0));
    if (!query.status().ok()) return query.status();
    return tenants;
  }

 private:
  const std::shared_ptr<SqlDatabase> database_;  // shared with the stores
};

}  // namespace

absl::StatusOr<std::unique_ptr<BlobStores>> OpenDirectoryBlobs(const std::string& root) {
  auto blobs = std::make_unique<DirectoryBlobs>(root);
  if (absl::Status usable = blobs->Of("").status(); !usable.ok()) return usable;
  return blobs;
}

absl::StatusOr<bool> HasDirectoryBlobs(const std::string& root) {
  if (!std::filesystem::exists(root)) return false;
  DirectoryBlobs blobs(root);
  const auto tenants = blobs.Tenants();
  if (!tenants.ok()) return tenants.status();
  for (const std::string& tenant : *tenants) {
    const auto store = blobs.Of(tenant);
    if (!store.ok()) return store.status();
    bool any = false;
    const absl::Status listed = (*store)->ForEach([&](const BlobEntry&) { any = true; });
    if (!listed.ok()) return listed;
    if (any) return true;
  }
  return false;
}

std::unique_ptr<BlobStores> MakePostgresBlobs(std::shared_ptr<SqlDatabase> database) {
  return std::make_unique<PostgresBlobs>(std::move(database));
}

}  // namespace slicefarm::coordinator
