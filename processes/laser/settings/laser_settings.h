#pragma once

#include "common/config/process_settings.h"

namespace slicefarm::config::laser {

/// Returns the settings of lasers that scan powder or resin. The result exists as long as the
/// program.
const ProcessSettings& Settings();

}  // namespace slicefarm::config::laser
