#pragma once

#include <string_view>

namespace slicefarm::gcode {

/// Returns true if lines of G-code do not change the state that programs track between layers: the
/// position of the nozzle, fans and accelerations. Returns false for unknown commands, including
/// macros. Cost: O(bytes).
bool LeavesModes(std::string_view code);

}  // namespace slicefarm::gcode
