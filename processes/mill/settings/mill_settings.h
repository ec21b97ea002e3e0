#pragma once

#include "common/config/process_settings.h"

namespace slicefarm::config::mill {

/// Returns the settings of milling in three axes. The result exists as long as the program.
const ProcessSettings& Settings();

}  // namespace slicefarm::config::mill
