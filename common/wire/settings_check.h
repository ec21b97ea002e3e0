#pragma once

#include "absl/status/status.h"
#include "google/protobuf/message.h"

namespace slicefarm {

/// Holds for a message of options and for those within it: messages and enums are given, enums are
/// known, doubles are finite, strings are at most limits::kMaxSettingBytes long. Walks the fields
/// by reflection, so that no new field is forgotten. Errors: REQUEST_MALFORMED or REQUEST_TOO_LARGE
/// naming the field.
absl::Status CheckComplete(const google::protobuf::Message& options);

}  // namespace slicefarm
