#pragma once

#include <cstdint>
#include <string>

#include "absl/status/status.h"

namespace slicefarm::coordinator {

/// The errors of BlobStore that do not depend on where blobs are kept.
absl::Status CheckBlobName(const std::string& digest);
absl::Status BlobNotFound(const std::string& digest);
absl::Status UploadOffset(const std::string& digest, int64_t committed, int64_t got);
absl::Status BlobMismatch(absl::StatusCode code, const std::string& digest, const std::string& got);

}  // namespace slicefarm::coordinator
