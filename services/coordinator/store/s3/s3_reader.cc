#include "services/coordinator/store/s3/s3_reader.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "absl/strings/str_cat.h"

namespace slicefarm::coordinator {
namespace {

/// Largest size of one request for a client that reads in order.
constexpr int64_t kAheadBytes = 4 << 20;

}  // namespace

absl::Status BucketAway(const absl::Status& status) {
  const bool of_bucket = absl::IsUnavailable(status) || absl::IsPermissionDenied(status) ||
                         absl::IsNotFound(status) || absl::IsAborted(status);
  return of_bucket ? StoreAway(absl::StrCat("S3: ", status.message())) : status;
}

/// Returns fewer bytes if the object or its rest is missing.
absl::StatusOr<std::string> S3Reader::Fetch(int64_t offset, int64_t count) {
  auto bytes = bucket_->Get(found_.object, offset, count);
  if (absl::IsNotFound(bytes.status())) return std::string();
  if (!bytes.ok()) return BucketAway(bytes.status());
  return bytes;
}

absl::StatusOr<std::string> S3Reader::ReadWithin(int64_t offset, int64_t count) {
  const bool in_order = offset == next_;
  next_ = offset + count;
  if (!in_order) return Fetch(offset, count);
  const int64_t skip = offset - ahead_at_;
  if (skip < 0 || skip + count > std::ssize(ahead_)) {
    // The first request reads only the first piece, because most readers need no more.
    const int64_t most = offset == 0 ? count : std::max(count, kAheadBytes);
    auto fetched = Fetch(offset, std::min(most, size() - offset));
    if (!fetched.ok()) return fetched;
    ahead_ = *std::move(fetched);
    ahead_at_ = offset;
  }
  return ahead_.substr(static_cast<size_t>(std::min(offset - ahead_at_, std::ssize(ahead_))),
                       static_cast<size_t>(count));
}

absl::StatusOr<std::string> MovingReader::ReadWithin(int64_t offset, int64_t count) {
  auto bytes = reader_->Read(offset, count);
  if (!absl::IsDataLoss(bytes.status())) return bytes;
  const auto found = index_->Find(digest_);
  if (!found.ok() || !*found || (*found)->size != size()) return bytes;
  reader_ = std::make_unique<S3Reader>(bucket_, **found);
  return reader_->Read(offset, count);
}

}  // namespace slicefarm::coordinator
