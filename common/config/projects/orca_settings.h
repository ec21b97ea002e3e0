#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/model/setting.h"

namespace slicefarm::config {

/// Settings without an exact equivalent in PrusaSlicer, in the order in which they were given.
struct OrcaUnused {
  std::vector<std::string> of_print;  ///< `key = value` of each setting that would change the print
  /// other settings: `key: reason`, or `key = value: reason` if PrusaSlicer has the setting but not
  /// this value
  std::vector<std::string> others;
};

/// Returns the key at the beginning of a line of OrcaUnused.
std::string_view KeyOfUnused(std::string_view line);

/// Converts settings of OrcaSlicer or Bambu Studio to PrusaSlicer's names and values. The result
/// has each setting once, in an order that does not depend on the order of `settings`. Each setting
/// keeps its `source`.
///
/// A JSON list (`["220","230"]`) is converted to a list if the setting has one item per extruder;
/// otherwise only its first item is used. Widths and accelerations in percent become numbers,
/// because PrusaSlicer's percentages have another base; the base settings must be among `settings`.
/// If there are temperatures for several beds, the temperature of `curr_bed_type` is used.
/// Placeholders in G-code become PrusaSlicer's placeholders, or the value in `settings` if
/// PrusaSlicer has none. Placeholders without either remain and cause an error when the G-code is
/// made.
///
/// Settings of older versions are read by their new names (Modernized).
///
/// `unused`: receives the settings without effect; may be null. `filament`: index of the printing
/// filament, from 0. Placeholders get the values of this filament. If a list has no item for this
/// filament, its first item is used. Cost: O(n log n) for n settings.
std::vector<Setting> FromOrca(std::span<const Setting> settings, OrcaUnused* unused,
                              size_t filament = 0);

}  // namespace slicefarm::config
