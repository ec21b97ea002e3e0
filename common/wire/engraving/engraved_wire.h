#pragma once

#include <cstddef>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/error.h"
#include "processes/engrave/model/engraved_layer.h"
#include "slicefarm/v1/texture.pb.h"

namespace slicefarm {

/// What the texture stage answers. Errors: REQUEST_MALFORMED with the way to the field.
absl::Status ToProto(const EngraveLayout& layout, v1::EngraveLayout* proto);
absl::StatusOr<EngraveLayout> FromProto(const v1::EngraveLayout& proto);
/// Without its text.
absl::Status ToProto(const EngravedLayer& layer, v1::EngravedLayer* proto);
absl::StatusOr<EngravedLayer> FromProto(const v1::EngravedLayer& proto);

/// A layer travels in pieces, as its text may be longer than a message: calls `send` with each of
/// them. Unavailable if that returns false: the peer takes no more.
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

/// The other end. Errors: REQUEST_MALFORMED for text of no layer, and for more of it than a program
/// may have.
absl::Status TakePiece(const v1::EngravedPiece& piece, std::vector<EngravedLayer>* layers);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
