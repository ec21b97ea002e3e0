#pragma once

#include <initializer_list>
#include <string_view>

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Returns true if at least one line of `gcode` has one of the commands, such as "M104".
bool Commands(std::string_view gcode, std::initializer_list<std::string_view> commands);

/// Returns true if the start G-code of the machine or of the filament has one of the commands.
bool StartCommands(const MotionOptions& options, std::initializer_list<std::string_view> commands);

}  // namespace slicefarm::motion
