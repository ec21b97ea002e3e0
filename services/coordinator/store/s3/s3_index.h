#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Index of a tenant's blobs in a bucket: the object of each blob. It is in the tables `s3_blobs`
/// and `s3_loose` of the jobs' database.
///
/// The name of an object is never used twice. The object is in `s3_loose` from before its put until
/// a blob is made of it, and again from the removal of the blob until the object's deletion. So the
/// database contains every object, no matter when a process is killed. A deletion never affects an
/// object that another process puts. The bucket never has to be listed. Thread-safe.
class S3Index {
 public:
  /// Object of a blob, and its size.
  struct Found {
    std::string object;
    int64_t size = 0;
  };

  S3Index(std::shared_ptr<SqlDatabase> database, std::string tenant)
      : database_(std::move(database)), tenant_(std::move(tenant)) {}

  /// Returns the object of a blob; nullopt if the blob is not in the bucket.
  absl::StatusOr<std::optional<Found>> Find(const std::string& digest);
  /// Returns the object as Find does, and marks the blob as used.
  absl::StatusOr<std::optional<Found>> Touch(const std::string& digest, int64_t now_us);

  /// Records an object before it is put.
  absl::Status Begin(const std::string& object, int64_t now_us);
  /// Makes an object the blob after it was put. Returns false if another object is the blob
  /// already; then this object stays loose. Errors: also Aborted if the object was given up after
  /// Begin.
  absl::StatusOr<bool> Complete(const std::string& digest, const Found& object, int64_t now_us);

  /// Removes a blob that was not used for `idle_s`, and makes its object loose. Returns nullopt if
  /// nothing was removed.
  absl::StatusOr<std::optional<Found>> Loosen(const std::string& digest, double idle_s,
                                              int64_t now_us);
  /// Removes the blob of a damaged object. The object stays for some time. Does nothing if another
  /// object is the blob.
  absl::Status PutAside(const std::string& digest, const std::string& object, int64_t now_us);

  /// Returns at most `limit` objects that may be deleted: objects without a blob; damaged objects
  /// that were put aside at least `aside_s` ago; and objects with a put that began a day ago.
  absl::StatusOr<std::vector<std::string>> Loose(double aside_s, int64_t now_us, int32_t limit);
  /// Removes an object from the index after its deletion.
  absl::Status Forget(const std::string& object);

  /// Returns the total size of the blobs.
  absl::StatusOr<int64_t> Bytes();
  /// Calls `visit` for each blob.
  absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit, int64_t now_us);

  /// Returns the tenants that have blobs or loose objects.
  static absl::StatusOr<std::vector<std::string>> Tenants(SqlDatabase& database);

 private:
  absl::StatusOr<std::optional<Found>> Remove(const std::string& digest, const std::string& object,
                                              int64_t touched_before_us, const char* state,
                                              int64_t now_us);

  const std::shared_ptr<SqlDatabase> database_;  // shared with other stores
  const std::string tenant_;
};

}  // namespace slicefarm::coordinator
