#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/layers/fill_stats.h"
#include "slicefarm/v1/layer.pb.h"

namespace slicefarm {

/// Converts the totals of an infill. Errors: REQUEST_MALFORMED, with the field, for an invalid
/// amount, index of settings, feature or pattern.
absl::Status ToProto(const FillStats& use, v1::FillStats* proto);
absl::StatusOr<FillStats> FromProto(const v1::FillStats& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
