#include "common/gcode/custom_code.h"

#include <algorithm>
#include <array>

#include "common/base/text.h"

namespace slicefarm::gcode {
namespace {

/// Commands for waits, temperatures, messages, progress, objects, extruder modes and limits.
constexpr std::array<std::string_view, 30> kHarmless = {"G4",
                                                        "G21",
                                                        "G90",
                                                        "M73",
                                                        "M74",
                                                        "M82",
                                                        "M83",
                                                        "M104",
                                                        "M105",
                                                        "M109",
                                                        "M117",
                                                        "M118",
                                                        "M140",
                                                        "M141",
                                                        "M190",
                                                        "M191",
                                                        "M220",
                                                        "M221",
                                                        "M300",
                                                        "M400",
                                                        "M486",
                                                        "M201",
                                                        "M203",
                                                        "M205",
                                                        "M566",
                                                        "M572",
                                                        "M900",
                                                        "SET_PRINT_STATS_INFO",
                                                        "SET_PRESSURE_ADVANCE",
                                                        "SET_DISPLAY_TEXT"};

/// Returns true if the line changes no tracked state. G92 does not change the position if it
/// concerns only the filament.
bool IsHarmless(std::string_view line) {
  const std::string_view command = line.substr(0, line.find_first_of(" \t"));
  if (command == "G92") return line.find_first_of("XYZ") == std::string_view::npos;
  return std::ranges::find(kHarmless, command) != kHarmless.end();
}

}  // namespace

bool LeavesModes(std::string_view code) {
  return std::ranges::all_of(Split(code, "\n"), [](std::string_view line) {
    line = Trim(line.substr(0, line.find(';')));
    return line.empty() || IsHarmless(line);
  });
}

}  // namespace slicefarm::gcode
