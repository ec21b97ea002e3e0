#pragma once

#include "common/config/process_settings.h"

namespace slicefarm::config::fdm {

/// Returns the settings of FDM. The result exists as long as the program.
const ProcessSettings& Settings();

}  // namespace slicefarm::config::fdm
