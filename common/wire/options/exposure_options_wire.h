#pragma once

#include "absl/status/statusor.h"
#include "common/model/options/exposure_settings.h"
#include "slicefarm/v1/settings.pb.h"

namespace slicefarm {

/// Options that come over the wire can be scanned with. Errors: REQUEST_MALFORMED,
/// REQUEST_TOO_LARGE, naming the field.
v1::ExposureSettings ToProto(const ExposureSettings& settings);
absl::StatusOr<ExposureSettings> FromProto(const v1::ExposureSettings& proto);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
