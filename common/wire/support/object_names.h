#pragma once

#include <string>

#include "absl/status/status.h"
#include "google/protobuf/repeated_field.h"

namespace slicefarm {

/// Checks the names of objects. Errors: REQUEST_TOO_LARGE for more names than a job may have
/// objects, and for long names.
absl::Status CheckObjectNames(const google::protobuf::RepeatedPtrField<std::string>& names);

}  // namespace slicefarm
