#pragma once

#include "common/model/options/settings.h"
#include "common/model/options/support_options.h"

namespace slicefarm::config::fdm {

/// Returns the row of RegionTable for a support region, derived from the settings of an object.
/// `settings`: resolved settings; only their first region is used.
///
///   row           density                    lines
///   first layer   raft_first_layer_density   at support_material_angle, in a loop
///   base          by its spacing             at support_material_angle; in a loop with a sheath
///   branches      0                          one loop or two loops
///   interfaces    by their spacing            at support_material_angle + 90 degrees
JobRows SupportRegionRow(JobRows settings, SupportRow row);

}  // namespace slicefarm::config::fdm
