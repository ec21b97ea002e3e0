#include "services/coordinator/store/blobs/blob_store.h"

#include <algorithm>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"

namespace slicefarm::coordinator {

absl::StatusOr<std::string> BlobReader::Read(int64_t offset, int64_t limit) {
  const int64_t count = std::clamp<int64_t>(size() - offset, 0, limit);
  if (count == 0) return std::string();
  auto bytes = ReadWithin(offset, count);
  if (!bytes.ok() || std::ssize(*bytes) == count) return bytes;
  return MakeError(
      absl::StatusCode::kDataLoss, Reason::kStoreFailed,
      absl::StrCat("of ", size(), " bytes of a blob, those from ", offset + std::ssize(*bytes),
                   " on have disappeared since it was opened"));
}

}  // namespace slicefarm::coordinator
