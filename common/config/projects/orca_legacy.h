#pragma once

#include "common/model/setting.h"

namespace slicefarm::config {

/// Returns a setting of older versions of OrcaSlicer and Bambu Studio as the newer versions read
/// it: with its new name, or with the new name of its value. Other settings are returned unchanged.
/// Source: OrcaSlicer 2.3, PrintConfig.
Setting Modernized(Setting setting);

}  // namespace slicefarm::config
