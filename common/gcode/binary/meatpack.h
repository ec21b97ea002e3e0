#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::gcode {

/// Lines of G-code as MeatPack has them, two characters in a byte where they are among those that
/// G-code is made of. Lines that are comments stay as they are, comments after commands go, as do
/// empty lines and the blanks of lines of G0, G1 and their like, which firmwares do not need: the
/// encoding "MeatPack modified to keep comment lines" of binary G-code.
/// Each text begins anew, so that it can be read by itself. A byte 0xff, which is no text, becomes
/// `?`. Cost: O(bytes).
/// Source: S. Mudge, MeatPack; libbgcode's specification.
std::string MeatPack(std::string_view lines);

/// Returns the lines of a text that MeatPack has packed, by this or another program. Errors:
/// InvalidArgument for a command of MeatPack that there is not, and for a text that ends within a
/// character.
absl::StatusOr<std::string> MeatUnpack(std::string_view packed);

}  // namespace slicefarm::gcode
