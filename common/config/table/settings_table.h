#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/table/setting_spec.h"
#include "common/model/process.h"

namespace slicefarm::config {

/// Returns all settings that have an effect on jobs of the process, sorted by key. The table is
/// made once; further calls are cheap.
std::span<const SettingSpec> SettingsTable(Process process);

/// Returns the specs of a process, in any order. Defined by processes/list/settings.cc, the list of
/// processes. Called once for each process.
std::vector<SettingSpec> SpecsOf(Process process);

/// Returns the index of the setting in SettingsTable(process), or -1 if there is none.
int FindSetting(std::string_view key, Process process);

/// Parses a value in the form of a config.ini. Of a list, only the first item is parsed. Errors:
/// SETTING_MALFORMED; SETTING_OUT_OF_RANGE with metadata `setting`, `value`, `min`, `max`. A
/// percentage of another setting is not checked here, but later, when its absolute value is known
/// (CheckRange).
absl::StatusOr<Value> ParseValue(const SettingSpec& spec, std::string_view text);

/// Checks that the number is in the setting's range. `written`: the value as the user wrote it, for
/// the message. Errors: SETTING_OUT_OF_RANGE.
absl::Status CheckRange(const SettingSpec& spec, double number, std::string_view written);

/// Returns the text of a value in canonical form, the inverse of ParseValue.
std::string PrintValue(const SettingSpec& spec, const Value& value);

/// Returns true if the text `written` means the setting's default value. Returns false for a text
/// that cannot be parsed.
bool IsStandard(const SettingSpec& spec, std::string_view written);

/// Returns the description of the valid values for messages: "0.01 to 2", "one of aligned, nearest,
/// rear".
std::string DescribeRange(const SettingSpec& spec);

}  // namespace slicefarm::config
