#pragma once

#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Each tenant's blobs, in a store of his own. The same bytes of two tenants are kept twice: so
/// none learns from his own what another has, be it by an answer, by its time, or by how long a
/// blob stays; and none can spoil or finish another's upload. Thread-safe.
class BlobStores {
 public:
  virtual ~BlobStores() = default;

  /// The blobs of a tenant; of no name: where there are none, or what they share. Errors:
  /// REQUEST_MALFORMED for what is no tenant's name; STORE_FAILED.
  virtual absl::StatusOr<std::shared_ptr<BlobStore>> Of(const std::string& tenant) = 0;

  /// Those who may have blobs; the one without a name among them. Errors: STORE_FAILED.
  virtual absl::StatusOr<std::vector<std::string>> Tenants() = 0;
};

/// In a directory: see DirectoryBlobStore; a tenant's is `tenants/NAME` in it. REQUIRES: no other
/// process uses it.
absl::StatusOr<std::unique_ptr<BlobStores>> OpenDirectoryBlobs(const std::string& root);

/// Returns true if a directory of OpenDirectoryBlobs has a blob of any tenant. Errors:
/// STORE_FAILED.
absl::StatusOr<bool> HasDirectoryBlobs(const std::string& root);

/// In PostgreSQL: see PostgresBlobStore.
std::unique_ptr<BlobStores> MakePostgresBlobs(std::shared_ptr<SqlDatabase> database);

}  // namespace slicefarm::coordinator
