#pragma once

#include <cstdint>
#include <string_view>

#include "absl/status/status.h"

namespace slicefarm::config {

/// Checks the sizes of a setting's key and value. Errors: REQUEST_TOO_LARGE with `limit` and `got`.
absl::Status CheckSettingSize(std::string_view key, std::string_view value);
/// Checks the number of settings. Errors: REQUEST_TOO_LARGE with `limit` and `got`.
absl::Status CheckSettingCount(int64_t count);

}  // namespace slicefarm::config
