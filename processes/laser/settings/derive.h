#pragma once

#include "absl/status/status.h"
#include "common/config/draft.h"

namespace slicefarm::config::laser {

/// Turns what refers to other settings into what it comes to: first_layer_height in percent, and
/// outline_resolution to no less than resolution. Errors: SETTING_OUT_OF_RANGE for what a
/// percentage comes to.
absl::Status Derive(Draft& draft);

}  // namespace slicefarm::config::laser
