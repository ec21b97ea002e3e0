#pragma once

#include "absl/status/status.h"
#include "common/config/draft.h"

namespace slicefarm::config::laser {

/// Checks that the values are consistent with each other. Errors: SETTING_OUT_OF_RANGE.
absl::Status CheckSettings(const Draft& draft);

}  // namespace slicefarm::config::laser
