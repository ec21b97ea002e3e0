#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/table/setting_spec.h"
#include "common/model/process.h"

namespace slicefarm::config {

/// All settings that have an effect on jobs of the process, sorted by key. Made once; cheap to
/// call.
std::span<const SettingSpec> SettingsTable(Process process);

/// Returns the specs of a process, in any order. Defined by processes/list/settings.cc, the list of
/// processes. Called once for each process.
std::vector<SettingSpec> SpecsOf(Process process);

/// Index into SettingsTable(process), or -1.
int FindSetting(std::string_view key, Process process);

/// Reads one value as a config.ini writes it. Of a list, the first item.
/// Errors: SETTING_MALFORMED, SETTING_OUT_OF_RANGE with metadata `setting`, `value`, `min`, `max`.
/// A percentage of another setting is checked once it is known what it comes to (CheckRange).
absl::StatusOr<Value> ParseValue(const SettingSpec& spec, std::string_view text);

/// SETTING_OUT_OF_RANGE unless the number lies in the setting's range. `written`: what the user
/// wrote.
absl::Status CheckRange(const SettingSpec& spec, double number, std::string_view written);

/// The inverse of ParseValue, in canonical form.
std::string PrintValue(const SettingSpec& spec, const Value& value);

/// Whether `written` says no more than the standard. False for what cannot be read.
bool IsStandard(const SettingSpec& spec, std::string_view written);

/// The range or the choices, for people: "0.01 to 2", "one of aligned, nearest, rear".
std::string DescribeRange(const SettingSpec& spec);

}  // namespace slicefarm::config
