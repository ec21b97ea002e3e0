#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "common/config/setting_values.h"

namespace slicefarm::config {

// Functions with which each process derives settings from other settings
// (ProcessSettings::Derive).

/// Returns the setting's absolute value: a percentage is converted to this share of `whole`.
double Absolute(const Value& value, double whole);

/// Replaces a percentage in setting `key` by an absolute number. REQUIRES: the setting to which the
/// percentage refers is already an absolute number.
void ResolvePercentage(SettingValues& draft, std::string_view key);

/// Replaces a value of 0 in setting `key` by the value of setting `to`.
void FallBack(SettingValues& draft, std::string_view key, std::string_view to);

/// Raises the value of setting `key` to the value of setting `least`, if `key` is smaller.
void RaiseTo(SettingValues& draft, std::string_view key, std::string_view least);

/// Checks that each setting that may be a percentage is in its range. REQUIRES: all percentages are
/// replaced by absolute numbers (ResolvePercentage). Errors: SETTING_OUT_OF_RANGE.
absl::Status CheckPercentages(const SettingValues& draft);

}  // namespace slicefarm::config
