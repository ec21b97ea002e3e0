#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "common/config/draft.h"

namespace slicefarm::config {

/// Steps from which processes build the derivation of settings from other settings.

/// Returns the setting's value, where a percentage refers to `whole`.
double Absolute(const Value& value, double whole);

/// Replaces a percentage by the absolute number. The setting to which the percentage refers must
/// already be an absolute number.
void TakePercentage(Draft& draft, std::string_view key);

/// Replaces a value of 0 by the value of another setting.
void FallBack(Draft& draft, std::string_view key, std::string_view to);

/// Raises a value to the value of another setting if it is smaller.
void RaiseTo(Draft& draft, std::string_view key, std::string_view least);

/// Checks that the absolute numbers from percentages are in range. Errors: SETTING_OUT_OF_RANGE.
absl::Status CheckPercentages(const Draft& draft);

}  // namespace slicefarm::config
