#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/milling/milling_options.h"
#include "slicefarm/v1/milling.pb.h"

namespace slicefarm {

/// What milling is told: complete or refused (settings_check.h). Whether the numbers make sense is
/// for the stage to say.
absl::Status ToProto(const MillSettings& settings, v1::MillSettings* proto);
/// Errors: REQUEST_MALFORMED, REQUEST_TOO_LARGE; those of ParseCutter.
absl::StatusOr<MillSettings> FromProto(const v1::MillSettings& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
