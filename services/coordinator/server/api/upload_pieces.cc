#include "services/coordinator/server/api/upload_pieces.h"

namespace slicefarm::coordinator {

absl::Status UploadPieces::Add(std::string_view chunk) {
  held_ += chunk;
  if (!begun_) return KeepSome(std::ssize(held_));
  const int64_t boundary = offset() - offset() % kBlobPieceBytes;
  return boundary > kept_ ? KeepSome(boundary - kept_) : absl::OkStatus();
}

absl::Status UploadPieces::KeepRest() {
  return held_.empty() ? absl::OkStatus() : KeepSome(std::ssize(held_));
}

absl::Status UploadPieces::KeepSome(int64_t bytes) {
  const auto status = keep_(kept_, std::string_view(held_).substr(0, bytes));
  if (!status.ok()) return status.status();
  status_ = *status;
  begun_ = true;
  kept_ += bytes;
  held_.erase(0, bytes);
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
