#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "common/config/missing_feature.h"
#include "common/model/setting.h"

namespace slicefarm::config::fdm {

/// Returns an `incompatible_profiles` feature for each condition in `given` that is false.
/// Filaments and print settings have conditions on the printer (compatible_printers_condition).
/// Filaments also have conditions on the print settings (compatible_prints_condition). If `given`
/// contains several profiles in sequence, each may have a condition. A whole config.ini contains
/// the conditions of all its profiles (compatible_printers_condition_cummulative); they replace the
/// conditions before it. A condition that cannot be evaluated counts as true, as in PrusaSlicer.
///
/// `settings_text`: ResolvedSettings::effective_text. Cost: O(settings) if there is a condition.
std::vector<MissingFeature> IncompatibleProfiles(std::span<const Setting> given,
                                                 std::string_view settings_text);

}  // namespace slicefarm::config::fdm
