#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/wire/shared_wire.h"
#include "processes/mill/model/mill_input.h"
#include "slicefarm/v1/milling.pb.h"

namespace slicefarm {

/// Converts the data that the calls of a milling job share. Errors: REQUEST_MALFORMED with the path
/// to the field; any error of ForEachPiece and MeshReader (mesh_pieces.h).
absl::Status ToProto(const MillInput& input, v1::MillInput* proto);
absl::StatusOr<MillInput> FromProto(const v1::MillInput& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
using slicefarm::ToProto;
}  // namespace v1

template <>
struct MessageOf<MillInput> {
  using Type = v1::MillInput;
};

}  // namespace slicefarm
