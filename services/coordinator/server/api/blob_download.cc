#include "services/coordinator/server/api/blob_download.h"

#include <grpcpp/support/sync_stream.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "common/base/error.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm::coordinator {
namespace {

constexpr size_t kChunkBytes = 64 << 10;

}  // namespace

bool SendBytes(std::string_view bytes, const Transfers::Moved& moved,
               grpc::ServerWriter<v1::DownloadResponse>& stream) {
  v1::DownloadResponse response;
  for (size_t at = 0; at < bytes.size(); at += kChunkBytes) {
    response.set_data(std::string(bytes.substr(at, kChunkBytes)));
    if (!stream.Write(response)) return false;
    moved(std::ssize(response.data()));
  }
  return true;
}

absl::Status CheckPart(const BlobReader& blob, int64_t offset, int64_t limit) {
  if (offset < 0 || offset > blob.size())
    return LimitError(Reason::kRequestMalformed, "offset", blob.size(), offset);
  return limit < 0 ? Malformed("limit", "is negative") : absl::OkStatus();
}

absl::Status SendBlob(BlobReader& blob, int64_t offset, int64_t limit,
                      const Transfers::Moved& moved,
                      grpc::ServerWriter<v1::DownloadResponse>& stream) {
  const int64_t end = limit == 0 ? blob.size() : offset + std::min(limit, blob.size() - offset);
  for (int64_t at = offset; at < end;) {
    const auto piece = blob.Read(at, std::min(kBlobPieceBytes - at % kBlobPieceBytes, end - at));
    if (!piece.ok()) return piece.status();
    at += std::ssize(*piece);
    if (!SendBytes(*piece, moved, stream)) break;
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
