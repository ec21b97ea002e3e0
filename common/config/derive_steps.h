#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "common/config/draft.h"

namespace slicefarm::config {

/// Steps of which processes derive settings from others.

/// The setting's value, a percentage taken of `whole`.
double Absolute(const Value& value, double whole);

/// Replaces a percentage by what it comes to of the setting it relates to, which must be an
/// absolute number by now.
void TakePercentage(Draft& draft, std::string_view key);

/// Replaces 0 by another setting's value.
void FallBack(Draft& draft, std::string_view key, std::string_view to);

/// Replaces what is less than another setting's value by that.
void RaiseTo(Draft& draft, std::string_view key, std::string_view least);

/// Whether what percentages came to is in range. Errors: SETTING_OUT_OF_RANGE.
absl::Status CheckPercentages(const Draft& draft);

}  // namespace slicefarm::config
