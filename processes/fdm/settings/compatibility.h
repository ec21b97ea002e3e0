#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "common/config/missing_feature.h"
#include "common/model/setting.h"

namespace slicefarm::config::fdm {

/// Returns `incompatible_profiles` for each condition among `given` that is not met: of filaments
/// and print settings on their printer (compatible_printers_condition) and of filaments on the
/// print settings (compatible_prints_condition). Each profile of several that come one after the
/// other may have one; a whole config.ini has all of its own
/// (compatible_printers_condition_cummulative), which replace those before it. A condition that
/// cannot be evaluated counts as met, as in PrusaSlicer.
///
/// `settings_text`: ResolvedSettings::effective_text. Cost: O(settings) if there is a condition.
std::vector<MissingFeature> IncompatibleProfiles(std::span<const Setting> given,
                                                 std::string_view settings_text);

}  // namespace slicefarm::config::fdm
