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

/// An upload as it comes, kept in pieces of kBlobPieceBytes, whatever the client's chunks are. What
/// comes first is kept at once, so that the upload is there as soon as it has begun. Holds less
/// than a piece and a chunk.
class UploadPieces {
 public:
  /// Keeps bytes that begin at `offset`.
  using Keep = std::function<absl::StatusOr<BlobStatus>(int64_t offset, std::string_view bytes)>;

  /// From `offset` on.
  UploadPieces(int64_t offset, Keep keep) : keep_(std::move(keep)), kept_(offset) {}

  /// Where the next chunk belongs.
  int64_t offset() const { return kept_ + std::ssize(held_); }

  /// Of what was kept last.
  const BlobStatus& status() const { return status_; }

  /// Errors: those of Keep.
  absl::Status Add(std::string_view chunk);

  /// What is left: also of a call that breaks.
  absl::Status KeepRest();

 private:
  absl::Status KeepSome(int64_t bytes);

  const Keep keep_;
  int64_t kept_;
  bool begun_ = false;
  std::string held_;  ///< begins at kept_
  BlobStatus status_;
};

}  // namespace slicefarm::coordinator
