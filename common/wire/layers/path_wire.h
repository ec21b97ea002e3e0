#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/path.h"
#include "slicefarm/v1/layer.pb.h"

namespace slicefarm {

/// Converts a feature to its message and back.
v1::Feature ToProto(Feature feature);
absl::StatusOr<Feature> FromProto(v1::Feature proto);

/// Converts a path. Errors: OUT_OF_RANGE for values that do not fit in 32-bit nanometres;
/// REQUEST_MALFORMED if the invariant of Path or the range of a field is violated.
absl::Status ToProto(const Path& path, v1::Path* proto);
absl::StatusOr<Path> FromProto(const v1::Path& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
