#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "services/coordinator/store/blobs/blob_store.h"

namespace slicefarm::coordinator {

/// Upload that is stored in pieces of kBlobPieceBytes, no matter in which chunks the client sends
/// it. The first chunk is stored at once, so that the upload exists from its beginning. Has at most
/// a piece and a chunk in memory.
class UploadPieces {
 public:
  /// Function that stores bytes of the upload, which begin at `offset`, and returns its new status.
  using Keep = std::function<absl::StatusOr<BlobStatus>(int64_t offset, std::string_view bytes)>;

  /// Begins or continues an upload at `offset`.
  UploadPieces(int64_t offset, Keep keep) : keep_(std::move(keep)), kept_(offset) {}

  /// Returns the offset of the next chunk.
  int64_t offset() const { return kept_ + std::ssize(held_); }

  /// Returns the status after the last store of bytes.
  const BlobStatus& status() const { return status_; }

  /// Adds the next chunk. Errors: errors of `keep`.
  absl::Status Add(std::string_view chunk);

  /// Stores the remaining bytes. Also used after a broken call.
  absl::Status KeepRest();

 private:
  absl::Status KeepSome(int64_t bytes);

  const Keep keep_;
  int64_t kept_;
  bool begun_ = false;
  std::string held_;  ///< bytes that begin at kept_ and are not stored yet
  BlobStatus status_;
};

}  // namespace slicefarm::coordinator
