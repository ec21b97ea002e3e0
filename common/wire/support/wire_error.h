#pragma once

#include <cstddef>
#include <string_view>

#include "absl/status/status.h"

namespace slicefarm {

/// Returns InvalidArgument, reason REQUEST_MALFORMED, with the name of the field in the message and
/// in the metadata `field`: "xy_nm: an odd number of values".
absl::Status Malformed(std::string_view field, std::string_view what);

/// Returns `status` with the enclosing message in front of the path to the field: `xy_nm` becomes
/// `walls.xy_nm` or `walls[3].xy_nm`.
absl::Status Within(std::string_view field, const absl::Status& status);
absl::Status Within(std::string_view field, size_t index, const absl::Status& status);

}  // namespace slicefarm
