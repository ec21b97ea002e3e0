#include "services/motion/algo/text/commands.h"

#include <algorithm>
#include <cctype>

#include "common/model/options/motion_options.h"

namespace slicefarm::motion {

bool Commands(std::string_view gcode, std::initializer_list<std::string_view> commands) {
  while (!gcode.empty()) {
    const size_t end = std::min(gcode.find('\n'), gcode.size());
    std::string_view line = gcode.substr(0, end);
    gcode.remove_prefix(std::min(end + 1, gcode.size()));
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    for (const std::string_view command : commands) {
      if (!line.starts_with(command)) continue;
      const bool whole = line.size() == command.size() ||
                         std::isdigit(static_cast<unsigned char>(line[command.size()])) == 0;
      if (whole) return true;
    }
  }
  return false;
}

bool StartCommands(const MotionOptions& options, std::initializer_list<std::string_view> commands) {
  return Commands(options.start_gcode, commands) ||
         Commands(options.tool().start_filament_gcode, commands);
}

}  // namespace slicefarm::motion
