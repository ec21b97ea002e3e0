#pragma once

#include <functional>
#include <string>

#include "google/protobuf/message.h"

namespace slicefarm {

/// For tests of converters: calls `visit` once for each leaf field of `original`, with a copy in
/// which this field alone has another, likewise valid value, and with the field's path. Repeated
/// fields: each element.
void ForEachChangedField(
    const google::protobuf::Message& original,
    const std::function<void(const std::string& path, const google::protobuf::Message&)>& visit);

}  // namespace slicefarm
