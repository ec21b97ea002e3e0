#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/model/setting.h"

namespace slicefarm::config {

/// Settings that PrusaSlicer has nothing for, or not with that value; in their order.
struct OrcaUnused {
  std::vector<std::string> of_print;  ///< `key = value` of what makes another print
  std::vector<std::string> others;    ///< `key`; `key = value` where only the value is unknown
};

/// Settings of OrcaSlicer or Bambu Studio under PrusaSlicer's names and with its values, in the
/// order of our table, each once; what they were given for stays (`source`).
///
/// A list, as JSON (`["220","230"]`), counts with its first item. Widths and accelerations in
/// percent become numbers, because PrusaSlicer relates them to other things; for that the settings
/// they are percentages of must be among `settings`. Of the temperatures of several beds that of
/// `curr_bed_type` counts. Placeholders in G-code become PrusaSlicer's, or, where it has none, the
/// value that `settings` have; others stay, and are an error when the G-code is made.
/// `unused`: takes what has no effect. `filament`: which one prints, from 0: of its values those
/// that placeholders become; of fewer values the first one. Cost: O(n log n).
std::vector<Setting> FromOrca(std::span<const Setting> settings, OrcaUnused* unused,
                              size_t filament = 0);

}  // namespace slicefarm::config
