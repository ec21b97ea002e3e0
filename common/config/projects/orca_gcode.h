#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/config/projects/orca_dialect.h"

namespace slicefarm::config {

/// Lines that OrcaSlicer and Bambu Studio write because of a setting, as an addition to slicefarm's
/// G-code settings.
struct AddedGcode {
  std::string_view key;           ///< setting of slicefarm that gets the lines, such as layer_gcode
  std::string lines;              ///< lines, with `\n` written as two characters
  bool in_front = false;          ///< true: before the lines of `key`; false: after them
  std::string_view because = {};  ///< setting of OrcaSlicer that asks for the lines
};

/// Returns the additions, in the order in which they are made:
/// - scan_first_layer: scan of the first layer;
/// - additional_cooling_fan_speed: fan beside the bed;
/// - activate_air_filtration: exhaust fan of the chamber;
/// - input_shaping_emit: input shapers;
/// - enable_power_loss_recovery: recovery after a power loss.
///
/// `given` is asked for each setting that has an effect.
/// Source: the G-code of OrcaSlicer 2.3 and Bambu Studio 2.4.
std::vector<AddedGcode> AddedGcodeOf(const OrcaLookup& given);

/// Returns the lines of a G-code setting with an addition.
std::string WithGcode(std::string_view lines, const AddedGcode& added);

}  // namespace slicefarm::config
