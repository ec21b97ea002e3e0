#pragma once

#include <vector>

#include "common/config/setting_note.h"
#include "common/config/setting_values.h"
#include "common/model/options/settings.h"

namespace slicefarm::config {

struct Need;
struct SettingSpec;

/// Returns the first need of a setting that is not met; null if its needs are met. A setting with
/// an unmet need has no effect.
const Need* UnmetNeedOf(const SettingSpec& spec, const SettingValues& draft,
                        const JobRows& settings);

/// Returns the given settings that have no effect because another setting disables them, as `key =
/// value: needs ...`, sorted by key. A profile lists every setting, so settings of a profile count
/// only if they differ from their default and the profile does not give the disabling setting.
std::vector<SettingNote> UnmetNeeds(const SettingValues& draft, const JobRows& settings);

}  // namespace slicefarm::config
