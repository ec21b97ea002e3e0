#pragma once

#include <string_view>

namespace slicefarm::gcode {

/// Returns true if lines of G-code change nothing of what programs keep track of between layers:
/// the place of the nozzle, fans and accelerations. Commands that are not known to leave them alone
/// may change them, macros among them. Cost: O(bytes).
bool LeavesModes(std::string_view code);

}  // namespace slicefarm::gcode
