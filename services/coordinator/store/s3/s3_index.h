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

/// Index of a tenant's blobs in a bucket: the object of each blob. The index is in the tables
/// `s3_blobs` and `s3_loose` of the jobs' database. A loose object is an object without a blob.
///
/// The name of an object is never used twice. An object is in `s3_loose` from the time before its
/// PUT until it becomes a blob, and again from the removal of the blob until the object is deleted.
/// So the database contains every object, no matter when a program is killed, and the bucket never
/// has to be listed. A deletion never affects an object that another program puts. Thread-safe.
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
  /// Returns the object as Find does, and records that the blob is used at `now_us`.
  absl::StatusOr<std::optional<Found>> Touch(const std::string& digest, int64_t now_us);

  /// Records a loose object before its PUT.
  absl::Status Begin(const std::string& object, int64_t now_us);
  /// Records after the PUT that the object is the blob `digest`. Returns false if the blob already
  /// has another object; then the new object stays loose. Errors: also Aborted if the object was
  /// removed from the index since Begin.
  absl::StatusOr<bool> Complete(const std::string& digest, const Found& object, int64_t now_us);

  /// Removes a blob that was not used for `idle_s` seconds; its object becomes loose. Returns the
  /// object, or nullopt if nothing was removed.
  absl::StatusOr<std::optional<Found>> Loosen(const std::string& digest, double idle_s,
                                              int64_t now_us);
  /// Removes the blob `digest` because its object is damaged. The object becomes loose and is kept
  /// for some time for inspection. Does nothing if the blob has another object now.
  absl::Status PutAside(const std::string& digest, const std::string& object, int64_t now_us);

  /// Returns at most `limit` loose objects that may be deleted: objects of removed blobs; damaged
  /// objects that were put aside at least `aside_s` seconds ago; and objects with an incomplete PUT
  /// that began at least a day ago.
  absl::StatusOr<std::vector<std::string>> Loose(double aside_s, int64_t now_us, int32_t limit);
  /// Removes a loose object from the index after its deletion.
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
