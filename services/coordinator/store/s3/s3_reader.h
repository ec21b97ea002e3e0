#pragma once

#include <memory>
#include <string>

#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/s3/s3_client.h"
#include "services/coordinator/store/s3/s3_index.h"

namespace slicefarm::coordinator {

/// Reads an object. As long as the reads are in order, each request fetches several pieces.
class S3Reader : public BlobReader {
 public:
  S3Reader(std::shared_ptr<S3Client> bucket, S3Index::Found found)
      : bucket_(std::move(bucket)), found_(std::move(found)) {}

  int64_t size() const override { return found_.size; }

 private:
  absl::StatusOr<std::string> ReadWithin(int64_t offset, int64_t count) override;
  absl::StatusOr<std::string> Fetch(int64_t offset, int64_t count);

  const std::shared_ptr<S3Client> bucket_;
  const S3Index::Found found_;
  int64_t next_ = 0;   ///< end of the last read; the next read is in order if it begins here
  std::string ahead_;  ///< bytes from offset ahead_at_ on that were fetched in advance
  int64_t ahead_at_ = 0;
};

/// Converts an error of S3Client to an error of BlobStore. A refusal of access counts as temporary,
/// like an unreachable server, because access may be granted again.
absl::Status BucketAway(const absl::Status& status);

/// Reads a blob of the staging store. If the blob is moved into the bucket during the reads,
/// continues with the object in the bucket.
class MovingReader : public BlobReader {
 public:
  MovingReader(std::unique_ptr<BlobReader> reader, std::string digest,
               std::shared_ptr<S3Client> bucket, std::shared_ptr<S3Index> index)
      : reader_(std::move(reader)),
        digest_(std::move(digest)),
        bucket_(std::move(bucket)),
        index_(std::move(index)) {}

  int64_t size() const override { return reader_->size(); }

 private:
  absl::StatusOr<std::string> ReadWithin(int64_t offset, int64_t count) override;

  std::unique_ptr<BlobReader> reader_;
  const std::string digest_;
  const std::shared_ptr<S3Client> bucket_;
  const std::shared_ptr<S3Index> index_;
};

}  // namespace slicefarm::coordinator
