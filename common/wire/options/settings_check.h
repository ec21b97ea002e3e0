#pragma once

#include <initializer_list>
#include <string_view>

#include "absl/status/status.h"
#include "common/geometry/point.h"
#include "google/protobuf/message.h"

namespace slicefarm {

/// Holds for a message of options and for those within it: messages and enums are given (messages
/// that are `optional` may be missing), enums are known, doubles are finite, strings are at most
/// limits::kMaxSettingBytes long. Walks the fields by reflection, so that no new field is
/// forgotten. Errors: REQUEST_MALFORMED or REQUEST_TOO_LARGE naming the field.
absl::Status CheckComplete(const google::protobuf::Message& options);

struct NamedLength {
  std::string_view field;
  Coord value_nm = 0;
};

/// REQUEST_MALFORMED naming the first field that is below `least_nm` or above limits::kMaxCoord.
absl::Status CheckLengths(std::initializer_list<NamedLength> lengths, Coord least_nm);

inline absl::Status CheckPositive(std::initializer_list<NamedLength> lengths) {
  return CheckLengths(lengths, 1);
}

inline absl::Status CheckNotNegative(std::initializer_list<NamedLength> lengths) {
  return CheckLengths(lengths, 0);
}

}  // namespace slicefarm
