#pragma once

#include <functional>
#include <string>

#include "google/protobuf/message.h"

namespace slicefarm {

/// Calls `visit` once for each leaf field of `original`, for tests of converters. `visit` gets the
/// path of the field, and a copy of `original` that has another valid value in this field only.
/// Every element of a repeated field is visited.
void ForEachChangedField(
    const google::protobuf::Message& original,
    const std::function<void(const std::string& path, const google::protobuf::Message&)>& visit);

}  // namespace slicefarm
