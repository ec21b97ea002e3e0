#pragma once

#include <limits>
#include <string_view>

#include "absl/status/status.h"
#include "common/config/draft.h"

namespace slicefarm::config {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// SETTING_OUT_OF_RANGE: a length, in mm, that does not fit other settings. `rule`: "it must ...";
/// `min`, `max`: the bounds, 0 and kUnbounded for none.
absl::Status Refuse(const Draft& draft, std::string_view key, std::string_view rule, double min,
                    double max);

}  // namespace slicefarm::config
