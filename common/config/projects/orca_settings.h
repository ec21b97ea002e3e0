#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/model/setting.h"

namespace slicefarm::config {

/// Settings that PrusaSlicer lacks, or lacks with the given value, in their order.
struct OrcaUnused {
  std::vector<std::string> of_print;  ///< `key = value` of each setting that would change the print
  /// `key` of the remaining settings; `key = value` if only the value is unknown
  std::vector<std::string> others;
};

/// Converts settings of OrcaSlicer or Bambu Studio to PrusaSlicer's names and values. The result
/// has each setting once, in the order of our table. The `source` of a setting is kept.
///
/// Of a JSON list (`["220","230"]`) only the first item is used. Widths and accelerations in
/// percent become numbers, because PrusaSlicer's percentages have another base; the base settings
/// must be among `settings`. If there are temperatures for several beds, the temperature of
/// `curr_bed_type` is used. Placeholders in G-code become PrusaSlicer's placeholders, or the value
/// in `settings` if PrusaSlicer has none. Other placeholders stay and cause an error when the
/// G-code is made.
///
/// `unused`: receives the settings without effect. `filament`: number of the printing filament,
/// from 0. Placeholders get the values of this filament; a list without a value for it gives its
/// first value. Cost: O(n log n) for n settings.
std::vector<Setting> FromOrca(std::span<const Setting> settings, OrcaUnused* unused,
                              size_t filament = 0);

}  // namespace slicefarm::config
