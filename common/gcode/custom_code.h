#pragma once

#include <string_view>

namespace slicefarm::gcode {

/// Returns true if lines of G-code do not change the state that a program's writer tracks between
/// layers: position of the nozzle, fans and accelerations (M204). Other limits and modes, such as
/// M203 and M83, may change. Returns false for unknown commands, including macros. Cost: O(bytes).
bool LeavesModes(std::string_view code);

}  // namespace slicefarm::gcode
