#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

/// Converts an enumerator of the model to its message value, which is one higher. The message value
/// 0 means that the sender did not set the field. For each pair of enumerations, static_asserts
/// check that the values correspond.
template <typename Proto, typename Model>
Proto EnumToProto(Model value) {
  return static_cast<Proto>(static_cast<int>(value) + 1);
}

/// Converts a message value to an enumerator. Errors: REQUEST_MALFORMED for 0 and for values above
/// `count`. `count`: number of enumerators of the model.
template <typename Model, typename Proto>
absl::StatusOr<Model> EnumFromProto(Proto value, int count, std::string_view field) {
  const int number = static_cast<int>(value);
  if (number == 0) return Malformed(field, "is not given");
  if (number < 1 || number > count) return Malformed(field, "is not a value of this version");
  return static_cast<Model>(number - 1);
}

}  // namespace slicefarm
