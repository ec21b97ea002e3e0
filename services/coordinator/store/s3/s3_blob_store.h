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

/// A tenant's blobs as objects of a bucket, and which those are in the jobs' database. Uploads that
/// are not complete are in another store, as no object can be appended to; so are blobs that were
/// there before the bucket was, until Settle moves them. Each blob is one PUT, whose digest the
/// server checks.
///
/// An object is `tenants/NAME/blobs/aa/DIGEST.RANDOM`, of no tenant `blobs/...`.
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
  /// Also deletes objects that are no blob any more.
  absl::StatusOr<int64_t> DropDamaged(double aside_s) override;
  absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit) override;

  /// Moves the complete blobs of the other store into the bucket; `moved` is told of each. One that
  /// is damaged is put aside there. What was moved before an error stays so.
  absl::Status Settle(const std::function<void(const BlobEntry&)>& moved);

 private:
  absl::StatusOr<BlobStatus> Move(const std::string& digest);
  absl::Status PutObject(const std::string& digest, const BodySource& body);
  absl::StatusOr<bool> HasGood(const std::string& digest);
  absl::StatusOr<std::string> Digest(const S3Index::Found& found, std::string* bytes);
  absl::Status Check(const std::string& digest, const S3Index::Found& found, std::string* bytes);

  const std::shared_ptr<S3Client> bucket_;   // shared with the readers that it gave
  const std::shared_ptr<BlobStore> staged_;  // may be shared with other stores
  const std::string folder_;
  const std::shared_ptr<S3Index> index_;
  CheckedBlobs checked_;
  NameLocks movers_;  ///< one puts a blob at a time, whose bytes may be 2 GB
};

}  // namespace slicefarm::coordinator
