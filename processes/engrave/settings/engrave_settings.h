#pragma once

#include "common/config/process_settings.h"

namespace slicefarm::config::engrave {

/// Returns the settings of textures on surfaces. The result exists as long as the program.
const ProcessSettings& Settings();

}  // namespace slicefarm::config::engrave
