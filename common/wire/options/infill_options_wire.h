#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/infill_options.h"
#include "google/protobuf/repeated_field.h"
#include "slicefarm/v1/settings.pb.h"

namespace slicefarm {

/// A table of options, by the rules of settings_wire.h, and the texts of its rows: a text of many
/// rows travels once, and is shared again where it arrives. Errors name the row in `field`, or
/// `texts`.
using InfillRows = google::protobuf::RepeatedPtrField<v1::InfillOptions>;
using RowTexts = google::protobuf::RepeatedPtrField<std::string>;
void ToProto(const std::vector<InfillOptions>& table, InfillRows* rows, RowTexts* texts);
absl::StatusOr<std::vector<InfillOptions>> FromProto(const InfillRows& rows, const RowTexts& texts,
                                                     std::string_view field);

}  // namespace slicefarm
