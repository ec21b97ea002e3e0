#pragma once

#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/milling/mill_input.h"
#include "common/wire/mesh_pieces.h"
#include "common/wire/support/message_stream.h"
#include "slicefarm/v1/milling.pb.h"

namespace slicefarm {

/// All of an input but its meshes.
absl::Status ToProto(const MillInput& input, v1::MillHead* proto);

/// The meshes that follow a head, in messages that have a field `piece`. OK too if the peer is
/// gone: it says why.
template <typename Request, typename Stream>
absl::Status SendMeshes(const MillInput& input, Stream& stream) {
  for (const IndexedMesh* mesh : {&input.part, &input.stock}) {
    Request request;
    absl::Status sent = ForEachPiece(*mesh, [&](const v1::MeshPiece& piece) {
      *request.mutable_piece() = piece;
      return stream.Write(request);
    });
    if (!sent.ok()) return sent;
  }
  return absl::OkStatus();
}

/// The other end: takes the meshes that follow a head.
class MillInputReader {
 public:
  /// Errors: REQUEST_MALFORMED with the way to the field; MESH_TOO_LARGE.
  static absl::StatusOr<MillInputReader> Begin(const v1::MillHead& head);
  absl::Status Add(const v1::MeshPiece& piece) { return meshes_.Add(piece); }
  /// The input with a digest of what came.
  absl::StatusOr<MillInput> Finish();

 private:
  MillInputReader(MillSettings settings, MeshReader meshes)
      : settings_(std::move(settings)), meshes_(std::move(meshes)) {}

  MillSettings settings_;
  MeshReader meshes_;
};

}  // namespace slicefarm
