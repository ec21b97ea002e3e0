#pragma once

#include "absl/status/status.h"
#include "common/model/exposure_options.h"

namespace slicefarm::exposure {

/// SETTING_OUT_OF_RANGE, with metadata `setting`, for options that cannot be scanned with. Names
/// are those of ExposureOptions.
absl::Status CheckExposure(const ExposureOptions& options);

}  // namespace slicefarm::exposure
