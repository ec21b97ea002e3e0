#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "services/coordinator/store/blobs/blob_stores.h"
#include "services/coordinator/store/s3/s3_blob_store.h"

namespace slicefarm::coordinator {

/// Blob stores in a bucket (S3BlobStore). `staged`: stores of uploads, and of blobs from the time
/// before the bucket was used.
class S3Blobs : public BlobStores {
 public:
  S3Blobs(std::shared_ptr<S3Client> bucket, std::shared_ptr<SqlDatabase> database,
          std::unique_ptr<BlobStores> staged)
      : bucket_(std::move(bucket)), database_(std::move(database)), staged_(std::move(staged)) {}

  absl::StatusOr<std::shared_ptr<BlobStore>> Of(const std::string& tenant) override;
  absl::StatusOr<std::vector<std::string>> Tenants() override;

  /// Calls S3BlobStore::MoveStaged for each tenant.
  absl::Status MoveStaged(const std::function<void(const BlobEntry&)>& moved);

 private:
  absl::StatusOr<std::shared_ptr<S3BlobStore>> StoreOf(const std::string& tenant);

  const std::shared_ptr<S3Client> bucket_;       // shared with the stores
  const std::shared_ptr<SqlDatabase> database_;  // shared with the stores
  const std::unique_ptr<BlobStores> staged_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<S3BlobStore>> stores_;  // shared with calls in flight
};

}  // namespace slicefarm::coordinator
