#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/motion/algo/program/gcode_machine.h"

namespace slicefarm::motion {

/// What a program is held against.
struct CheckSetup {
  MachineSetup machine;
  double nozzle_mm = 0.4;
  double filament_mm = 1.75;  ///< diameter
  double z_offset_mm = 0;
  Polygon bed;             ///< empty: not known
  double max_height_mm = 0;  ///< 0: not known
};

/// Something wrong in a program.
struct Finding {
  int64_t line = 0;  ///< from 1
  std::string text;

  friend bool operator==(const Finding&, const Finding&) = default;
};

struct ProgramReport {
  std::vector<Finding> findings;  ///< in the order of their lines, at most kMostFindings
  int64_t found = 0;              ///< all
  int64_t lines = 0;
  int64_t moves = 0;
  double filament_mm = 0;  ///< of what the slicer prints: net of retractions, without custom code
};

inline constexpr size_t kMostFindings = 1000;

/// Reads a program strictly, as its firmware would, and tells what is wrong:
///   words that cannot be read, moves with a bare word, speeds not above 0;
///   commands that the firmware does not know (macros are the user's own in custom G-code);
///   moves beyond bed and height (custom G-code may prime kCustomMarginMm beside the bed);
///   beads of more than four times the nozzle's square, filament pushed at once beyond what the
///   firmware takes;
///   arcs whose ends are not as far from the centre, or in a form that the firmware does not take;
///   printing while retracted, restarts without a retraction;
///   extrusion before a temperature is set;
///   a sum of filament other than `; filament used [mm]` says.
/// Custom G-code is what ;TYPE:Custom says, and all before the first layer. Cost: O(bytes).
ProgramReport CheckProgram(std::string_view gcode, const Firmware& firmware,
                           const CheckSetup& setup);

/// Some printers' own start G-code goes so far over the edge of the bed.
inline constexpr double kCustomMarginMm = 10;

}  // namespace slicefarm::motion
