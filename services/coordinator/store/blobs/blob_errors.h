#pragma once

#include <cstdint>
#include <string>

#include "absl/status/status.h"

namespace slicefarm::coordinator {

/// Checks that a blob's name is a digest. Errors: REQUEST_MALFORMED. All kinds of blob stores
/// return this error and the errors below.
absl::Status CheckBlobName(const std::string& digest);
/// Returns the error BLOB_NOT_FOUND.
absl::Status BlobNotFound(const std::string& digest);
/// Returns the error UPLOAD_OFFSET, with the size of the upload and the offset of the call.
absl::Status UploadOffset(const std::string& digest, int64_t committed, int64_t got);
/// Returns the error BLOB_DIGEST_MISMATCH. `got`: digest of the actual bytes.
absl::Status BlobMismatch(absl::StatusCode code, const std::string& digest, const std::string& got);

}  // namespace slicefarm::coordinator
