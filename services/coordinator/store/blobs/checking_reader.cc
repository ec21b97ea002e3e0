#include "services/coordinator/store/blobs/checking_reader.h"

#include <utility>

#include "common/base/sha256.h"
#include "services/coordinator/store/blobs/blob_errors.h"

namespace slicefarm::coordinator {
namespace {

class CheckingReader : public BlobReader {
 public:
  CheckingReader(std::shared_ptr<BlobStore> store, std::string digest,
                 std::unique_ptr<BlobReader> reader)
      : store_(std::move(store)), digest_(std::move(digest)), reader_(std::move(reader)) {}

  int64_t size() const override { return reader_->size(); }

 private:
  absl::StatusOr<std::string> ReadWithin(int64_t offset, int64_t count) override {
    auto bytes = reader_->Read(offset, count);
    if (!bytes.ok() || offset != hashed_) return bytes;
    sha_.Add(*bytes);
    hashed_ += std::ssize(*bytes);
    if (hashed_ < size()) return bytes;
    const std::string got = sha_.Hex();
    if (got == digest_) return bytes;
    // Open reads the blob once more and puts it aside if it is damaged.
    if (const auto opened = store_->Open(digest_); !opened.ok()) return opened.status();
    return BlobMismatch(absl::StatusCode::kDataLoss, digest_, got);
  }

  const std::shared_ptr<BlobStore> store_;
  const std::string digest_;
  const std::unique_ptr<BlobReader> reader_;
  Sha256 sha_;
  int64_t hashed_ = 0;
};

}  // namespace

absl::StatusOr<std::unique_ptr<BlobReader>> OpenToStream(std::shared_ptr<BlobStore> store,
                                                         const std::string& digest) {
  auto reader = store->OpenUnchecked(digest);
  if (!reader.ok()) return reader.status();
  return std::make_unique<CheckingReader>(std::move(store), digest, *std::move(reader));
}

}  // namespace slicefarm::coordinator
