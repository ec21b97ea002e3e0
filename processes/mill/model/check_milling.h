#pragma once

#include "absl/status/status.h"
#include "processes/mill/model/milling_options.h"

namespace slicefarm {

/// Returns SETTING_OUT_OF_RANGE, with `setting` and `got`, for the first number out of its range.
absl::Status CheckMillingOptions(const MillingOptions& options);

}  // namespace slicefarm
