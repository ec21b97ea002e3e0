#pragma once

#include <functional>
#include <memory>
#include <string>

#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/blobs/checked_blobs.h"
#include "services/coordinator/store/blobs/name_locks.h"
#include "services/coordinator/store/s3/s3_client.h"
#include "services/coordinator/store/s3/s3_index.h"

namespace slicefarm::coordinator {

/// Blobs of a tenant as objects of a bucket (one PUT per blob, of which the server checks the
/// digest). The jobs' database contains the name of each blob's object (S3Index). Incomplete
/// uploads are in a staging store, because bytes cannot be appended to an object. Blobs from the
/// time before the bucket was used are also in the staging store, until MoveStaged moves them.
///
/// The name of an object is `tenants/NAME/blobs/aa/DIGEST.RANDOM`. Without a tenant, it begins with
/// `blobs/`.
class S3BlobStore : public BlobStore {
 public:
  S3BlobStore(std::shared_ptr<S3Client> bucket, std::shared_ptr<SqlDatabase> database,
              std::shared_ptr<BlobStore> staged, std::string tenant);

  absl::StatusOr<BlobStatus> Status(const std::string& digest) override;
  absl::StatusOr<BlobStatus> Keep(const std::string& digest) override;
  absl::StatusOr<BlobStatus> Append(const std::string& digest, int64_t offset,
                                    std::string_view bytes) override;
  absl::StatusOr<BlobStatus> Finish(const std::string& digest, int64_t size) override;
  absl::StatusOr<std::string> PutText(const SpooledText& text) override;
  absl::StatusOr<std::unique_ptr<BlobReader>> Open(const std::string& digest) override;
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenUnchecked(const std::string& digest) override;
  absl::StatusOr<std::string> Get(const std::string& digest) override;
  absl::StatusOr<bool> Delete(const std::string& digest, double idle_s) override;
  absl::StatusOr<int64_t> KeptBytes() override;
  /// Removes damaged blobs, and deletes objects without a blob.
  absl::StatusOr<int64_t> DropDamaged(double aside_s) override;
  absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit) override;

  /// Moves the complete blobs of the staging store into the bucket, and calls `moved` for each.
  /// Damaged blobs stay in the staging store and are put aside. After an error, the blobs that were
  /// moved before stay in the bucket.
  absl::Status MoveStaged(const std::function<void(const BlobEntry&)>& moved);

 private:
  absl::StatusOr<BlobStatus> Move(const std::string& digest);
  absl::Status PutObject(const std::string& digest, const BodySource& body);
  absl::StatusOr<bool> HasGood(const std::string& digest);
  absl::StatusOr<std::string> Digest(const S3Index::Found& found, std::string* bytes);
  absl::Status Check(const std::string& digest, const S3Index::Found& found, std::string* bytes);

  const std::shared_ptr<S3Client> bucket_;   // shared with the readers that it returned
  const std::shared_ptr<BlobStore> staged_;  // may be shared with other stores
  const std::string folder_;
  const std::shared_ptr<S3Index> index_;
  CheckedBlobs checked_;
  /// Locks by digest: only one thread at a time writes a blob, which may have 2 GB.
  NameLocks movers_;
};

}  // namespace slicefarm::coordinator
