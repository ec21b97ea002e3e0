#pragma once

#include <cstddef>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/error.h"
#include "processes/engrave/model/engraved_layer.h"
#include "slicefarm/v1/texture.pb.h"

namespace slicefarm {

/// Converts the results of the texture stage. Errors: REQUEST_MALFORMED with the path to the field.
absl::Status ToProto(const EngraveLayout& layout, v1::EngraveLayout* proto);
absl::StatusOr<EngraveLayout> FromProto(const v1::EngraveLayout& proto);
/// Converts a layer without its text (see SendPieces).
absl::Status ToProto(const EngravedLayer& layer, v1::EngravedLayer* proto);
absl::StatusOr<EngravedLayer> FromProto(const v1::EngravedLayer& proto);

/// Sends a layer in pieces, because its text may be longer than a message. Calls `send` with each
/// piece. Errors: Unavailable if `send` returns false because the peer has stopped reading.
template <typename Send>
absl::Status SendPieces(const EngravedLayer& layer, const Send& send) {
  constexpr size_t kPieceBytes = 1 << 20;
  v1::EngravedPiece piece;
  absl::Status status = ToProto(layer, piece.mutable_layer());
  if (!status.ok()) return status;
  bool there = send(piece);
  for (size_t at = 0; there && at < layer.text.size(); at += kPieceBytes) {
    piece.set_text(layer.text.substr(at, kPieceBytes));
    there = send(piece);
  }
  if (there) return absl::OkStatus();
  return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable, "the peer went away");
}

/// Appends a received piece to `layers`: a new layer, or text of the last layer. Errors:
/// REQUEST_MALFORMED for text before the first layer, and for more text than a program may have.
absl::Status TakePiece(const v1::EngravedPiece& piece, std::vector<EngravedLayer>* layers);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
