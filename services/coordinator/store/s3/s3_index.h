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

/// Which object of a bucket a tenant's blobs are, in the tables `s3_blobs` and `s3_loose` of the
/// jobs' database.
///
/// The name of an object is never given twice, and stands in `s3_loose` from before it is put until
/// a blob is made of it, and again from when that is none any more until the object is deleted. So
/// each object is known to somebody, whoever is killed when; what is deleted is never what another
/// one puts; and nobody needs a list of the bucket. Thread-safe.
class S3Index {
 public:
  struct Found {
    std::string object;
    int64_t size = 0;
  };

  S3Index(std::shared_ptr<SqlDatabase> database, std::string tenant)
      : database_(std::move(database)), tenant_(std::move(tenant)) {}

  absl::StatusOr<std::optional<Found>> Find(const std::string& digest);
  /// The same; the blob counts as used.
  absl::StatusOr<std::optional<Found>> Touch(const std::string& digest, int64_t now_us);

  /// An object is about to be put.
  absl::Status Begin(const std::string& object, int64_t now_us);
  /// It was, and is the blob now. False: another object is the blob already, and this one stays
  /// loose. Errors also: Aborted if the object was given up since Begin.
  absl::StatusOr<bool> Complete(const std::string& digest, const Found& object, int64_t now_us);

  /// The blob is none any more, if it was not used for so long; its object is loose. None: nothing
  /// happened.
  absl::StatusOr<std::optional<Found>> Loosen(const std::string& digest, double idle_s,
                                              int64_t now_us);
  /// The same of this very object, which is damaged and stays for some time. Nothing happens if
  /// another one is the blob.
  absl::Status PutAside(const std::string& digest, const std::string& object, int64_t now_us);

  /// Objects that can be deleted, at most so many: those that are no blob any more; damaged ones
  /// that were put aside so long ago; those that somebody began to put a day ago.
  absl::StatusOr<std::vector<std::string>> Loose(double aside_s, int64_t now_us, int32_t limit);
  /// The object was deleted.
  absl::Status Forget(const std::string& object);

  absl::StatusOr<int64_t> Bytes();
  absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit, int64_t now_us);

  /// Those who have blobs or loose objects.
  static absl::StatusOr<std::vector<std::string>> Tenants(SqlDatabase& database);

 private:
  absl::StatusOr<std::optional<Found>> Remove(const std::string& digest, const std::string& object,
                                              int64_t touched_before_us, const char* state,
                                              int64_t now_us);

  const std::shared_ptr<SqlDatabase> database_;  // shared with other stores
  const std::string tenant_;
};

}  // namespace slicefarm::coordinator
