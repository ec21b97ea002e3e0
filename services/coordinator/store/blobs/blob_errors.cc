#include "services/coordinator/store/blobs/blob_errors.h"

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/sha256.h"

namespace slicefarm::coordinator {

absl::Status CheckBlobName(const std::string& digest) {
  if (IsSha256Hex(digest)) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   "a blob's name must be a SHA-256 of 64 lower-case hex digits");
}

absl::Status BlobNotFound(const std::string& digest) {
  return MakeError(absl::StatusCode::kNotFound, Reason::kBlobNotFound,
                   absl::StrCat("there is no mesh or result ", digest), {{"sha256", digest}});
}

absl::Status UploadOffset(const std::string& digest, int64_t committed, int64_t got) {
  return MakeError(
      absl::StatusCode::kFailedPrecondition, Reason::kUploadOffset,
      absl::StrCat("the upload of ", digest, " continues at ", committed, ", not at ", got),
      {{"committed_size", absl::StrCat(committed)}, {"got", absl::StrCat(got)}});
}

absl::Status BlobMismatch(absl::StatusCode code, const std::string& digest,
                          const std::string& got) {
  return MakeError(code, Reason::kBlobDigestMismatch,
                   absl::StrCat("the bytes of blob ", digest, " have the digest ", got),
                   {{"sha256", digest}, {"got", got}});
}

}  // namespace slicefarm::coordinator
