#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/config/projects/orca_dialect.h"

namespace slicefarm::config {

/// Setting of slicefarm with a value that follows from several settings of OrcaSlicer.
struct PairedSetting {
  std::string_view key;
  std::string value;
  std::string_view because;  ///< setting of OrcaSlicer that is given and asks for the value
};

/// Returns the settings that follow from several settings of OrcaSlicer. `given` is asked for each
/// setting that has an effect. Settings that OrcaSlicer ignores because of another setting are left
/// out:
///
///   accel_to_decel_factor        accel_to_decel_enable = 1
///   print_flow_ratio             in addition to filament_flow_ratio
///   outer_wall_flow_ratio, ...   set_other_flow_ratios = 1
///   bottom_solid_infill_flow_ratio   without internal_solid_infill_flow_ratio
///   slow_down_for_layer_cooling  0: the fan still follows the layer times
///   pellet_flow_coefficient      pellet_modded_printer = 1; replaces the filament's diameter
///   max_bridge_length, support_critical_regions_only, tree_support_...   supports of type tree
std::vector<PairedSetting> PairedSettingsOf(const OrcaLookup& given);

}  // namespace slicefarm::config
