#pragma once

#include <string>

#include "absl/status/status.h"
#include "google/protobuf/repeated_field.h"

namespace slicefarm {

/// Checks the names of objects. Errors: REQUEST_TOO_LARGE for more than limits::kMaxObjects names,
/// and for a name longer than limits::kMaxNameBytes.
absl::Status CheckObjectNames(const google::protobuf::RepeatedPtrField<std::string>& names);

}  // namespace slicefarm
