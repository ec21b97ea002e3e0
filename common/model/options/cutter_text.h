#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/model/options/cutter.h"

namespace slicefarm {

/// Forms of text that ParseCutter accepts, for messages.
inline constexpr std::string_view kCutterForms =
    "cyl:D, ball:D, bull:D:CORNER, cone:D:ANGLE, ballcone:TIP:ANGLE:D, "
    "bullcone:TIP:CORNER:ANGLE:D, conecone:TIP:TIP_ANGLE:ANGLE:D";

/// Parses a cutter's text, with sizes in mm and degrees: cyl:DIAMETER, ball:DIAMETER,
/// bull:DIAMETER:CORNER, cone:DIAMETER:ANGLE, ballcone:TIP:ANGLE:DIAMETER,
/// bullcone:TIP:CORNER:ANGLE:DIAMETER, conecone:TIP:TIP_ANGLE:ANGLE:DIAMETER. TIP is the diameter
/// at which the upper cone begins; for a ball or a bull nose it is the full diameter of that tip.
/// Errors: SETTING_MALFORMED for a text in none of these forms; SETTING_OUT_OF_RANGE for sizes that
/// Cutter does not accept.
absl::StatusOr<Cutter> ParseCutter(std::string_view text);

}  // namespace slicefarm
