#pragma once

#include "common/config/process_settings.h"

namespace slicefarm::config::mill {

/// The settings of milling in three axes. Lives as long as the program.
const ProcessSettings& Settings();

}  // namespace slicefarm::config::mill
