#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/orientation_advice.h"
#include "common/model/scene/placement.h"
#include "slicefarm/v1/mesh.pb.h"
#include "slicefarm/v1/thumbnail.pb.h"

namespace slicefarm {

/// Converts a mesh format to its message and back.
v1::MeshFormat ToProto(MeshFormat format);
absl::StatusOr<MeshFormat> FromProto(v1::MeshFormat proto);

/// Converts a placement. A message may omit values: the defaults are 1 mm for the unit, 1 for the
/// scale and 0 for the rotation. A single scale applies to all axes. Errors: REQUEST_MALFORMED for
/// wrong numbers of values, non-finite numbers and scales that are not positive; OUT_OF_RANGE;
/// REQUEST_TOO_LARGE for more than limits::kMaxObjects copies.
absl::Status ToProto(const Placement& placement, v1::Placement* proto);
absl::StatusOr<Placement> FromProto(const v1::Placement& proto);

/// Converts the report of a mesh to its message and back.
v1::MeshReport ToProto(const MeshReport& report);
absl::StatusOr<MeshReport> FromProto(const v1::MeshReport& proto);

/// Converts orientation advice to its message and back.
v1::OrientationAdvice ToProto(const OrientationAdvice& advice);
absl::StatusOr<OrientationAdvice> FromProto(const v1::OrientationAdvice& proto);

/// Converts a thumbnail to its message and back.
v1::Thumbnail ToProto(const Thumbnail& thumbnail);
absl::StatusOr<Thumbnail> FromProto(const v1::Thumbnail& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
