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
/// contains several profiles in sequence, the conditions of all of them apply. A whole config.ini
/// lists the conditions of all its profiles in one setting, such as
/// compatible_printers_condition_cummulative. This list replaces the conditions of the same kind
/// that precede it in `given`. A condition that cannot be evaluated counts as true, as in
/// PrusaSlicer.
///
/// `settings_text`: ResolvedSettings::effective_text. Cost: O(settings) if there is a condition.
std::vector<MissingFeature> IncompatibleProfiles(std::span<const Setting> given,
                                                 std::string_view settings_text);

}  // namespace slicefarm::config::fdm
