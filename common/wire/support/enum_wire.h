#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

/// Enums of the wire are those of the model, one higher: 0 says that the sender forgot. Each pair
/// is held to that by static_asserts where it is converted.
template <typename Proto, typename Model>
Proto EnumToProto(Model value) {
  return static_cast<Proto>(static_cast<int>(value) + 1);
}

/// Errors: Malformed for 0 and for values of a later version. `count`: how many values the model
/// has.
template <typename Model, typename Proto>
absl::StatusOr<Model> EnumFromProto(Proto value, int count, std::string_view field) {
  const int number = static_cast<int>(value);
  if (number == 0) return Malformed(field, "is not given");
  if (number < 1 || number > count) return Malformed(field, "is not a value of this version");
  return static_cast<Model>(number - 1);
}

}  // namespace slicefarm
