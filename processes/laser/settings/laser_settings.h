#pragma once

#include "common/config/process_settings.h"

namespace slicefarm::config::laser {

/// The settings of lasers that scan powder or resin. Lives as long as the program.
const ProcessSettings& Settings();

}  // namespace slicefarm::config::laser
