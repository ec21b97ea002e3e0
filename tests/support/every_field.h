#pragma once

#include <functional>
#include <string>

#include "google/protobuf/message.h"

namespace slicefarm {

/// Calls `visit` once for each leaf field of `original`, for tests of converters. `visit` gets a
/// copy with another valid value in this field only, and the field's path. In repeated fields each
/// element is visited.
void ForEachChangedField(
    const google::protobuf::Message& original,
    const std::function<void(const std::string& path, const google::protobuf::Message&)>& visit);

}  // namespace slicefarm
