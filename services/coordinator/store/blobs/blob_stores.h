#pragma once

#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Blob stores of all tenants, one store per tenant. If two tenants have the same bytes, the bytes
/// are stored twice. If they were stored once, a tenant could learn about another tenant's data:
/// from an answer, from the time that the answer takes, or from the time for which a blob stays. A
/// tenant could also damage or finish another tenant's upload. Thread-safe.
class BlobStores {
 public:
  virtual ~BlobStores() = default;

  /// Returns the store of a tenant. The empty name is for a farm without tenants, or for shared
  /// data. Errors: REQUEST_MALFORMED for an invalid tenant name; STORE_FAILED.
  virtual absl::StatusOr<std::shared_ptr<BlobStore>> Of(const std::string& tenant) = 0;

  /// Returns the tenants that may have blobs, including the empty name. Errors: STORE_FAILED.
  virtual absl::StatusOr<std::vector<std::string>> Tenants() = 0;
};

/// Opens the blob stores in a directory (DirectoryBlobStore). The store of a tenant is in
/// `tenants/NAME`. REQUIRES: no other program uses the directory.
absl::StatusOr<std::unique_ptr<BlobStores>> OpenDirectoryBlobs(const std::string& root);

/// Returns true if a directory of OpenDirectoryBlobs has a blob of any tenant. Errors:
/// STORE_FAILED.
absl::StatusOr<bool> HasDirectoryBlobs(const std::string& root);

/// Returns the blob stores in a PostgreSQL database (PostgresBlobStore).
std::unique_ptr<BlobStores> MakePostgresBlobs(std::shared_ptr<SqlDatabase> database);

}  // namespace slicefarm::coordinator
