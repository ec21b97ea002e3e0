#pragma once

#include <vector>

#include "common/config/setting_note.h"
#include "common/config/setting_values.h"
#include "common/model/options/settings.h"

namespace slicefarm::config {

/// Returns the given settings that have no effect because another setting disables them, as `key =
/// value: needs ...`, sorted by key. A profile lists every setting, so settings of a profile count
/// only if they differ from their default and the profile does not give the disabling setting.
std::vector<SettingNote> UnmetNeeds(const SettingValues& draft, const JobRows& settings);

}  // namespace slicefarm::config
