#pragma once

#include "common/config/process_settings.h"

namespace slicefarm::config::engrave {

/// The settings of textures on surfaces. Lives as long as the program.
const ProcessSettings& Settings();

}  // namespace slicefarm::config::engrave
