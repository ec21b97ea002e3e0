#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::gcode {

/// Packs lines of G-code in the format of MeatPack: frequent characters of G-code are packed two
/// per byte. Comment lines remain unchanged. Comments after commands and empty lines are removed.
/// Blanks in lines of G0, G1 and similar commands are also removed, because firmwares do not need
/// them. This is the encoding "MeatPack modified to keep comment lines" of binary G-code. Each text
/// is packed independently, so that it can be read independently. A byte 0xff, which is not text,
/// becomes `?`. Cost: O(bytes). Source: S. Mudge, MeatPack; libbgcode's specification.
std::string MeatPack(std::string_view lines);

/// Returns the lines of a text that this or another program has packed with MeatPack. Errors:
/// InvalidArgument for an unknown command of MeatPack, and for a text that ends within a character.
absl::StatusOr<std::string> MeatUnpack(std::string_view packed);

}  // namespace slicefarm::gcode
