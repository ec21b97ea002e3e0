#pragma once

#include "common/config/process_settings.h"

namespace slicefarm::config::fdm {

/// The settings of filament printing. Lives as long as the program.
const ProcessSettings& Settings();

}  // namespace slicefarm::config::fdm
