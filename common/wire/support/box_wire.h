#pragma once

#include "absl/status/statusor.h"
#include "common/geometry/measure.h"
#include "common/wire/support/geometry_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

// Boxes in messages that have the fields `min` and `max`. Both are absent for an empty box.

/// Writes a box to the fields of a message.
template <typename Proto>
absl::Status BoxToProto(const Box& box, Proto* proto) {
  if (box.Empty()) return absl::OkStatus();
  if (absl::Status status = ToProto(box.min, proto->mutable_min()); !status.ok())
    return Within("min", status);
  const absl::Status status = ToProto(box.max, proto->mutable_max());
  return status.ok() ? status : Within("max", status);
}

/// Reads a box. Errors: REQUEST_MALFORMED if only one of the fields is present, and if max is less
/// than min.
template <typename Proto>
absl::StatusOr<Box> BoxFromProto(const Proto& proto) {
  if (proto.has_min() != proto.has_max()) return Malformed("min, max", "only one is given");
  if (!proto.has_min()) return Box();
  const Box box{FromProto(proto.min()), FromProto(proto.max())};
  if (box.Empty()) return Malformed("min, max", "max is less than min");
  return box;
}

}  // namespace slicefarm
