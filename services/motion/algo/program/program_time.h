#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "services/motion/algo/program/gcode_machine.h"

namespace slicefarm::motion {

/// Duration of a program and its parts. Times in s.
struct ProgramTime {
  double move_s = 0;     ///< time of all moves
  double dwell_s = 0;    ///< pauses of G4
  double heating_s = 0;  ///< waits for heat with a known rate
  /// Printing time per feature. Keys: the names in the slicer's `;TYPE:` comments; "None" before
  /// the first one.
  std::map<std::string, double> feature_s;
  double travel_s = 0;   ///< moves without printing
  double retract_s = 0;  ///< time of moves in which only the filament moves
  double before_s = 0;   ///< moves and dwells before the first layer's comment
  std::vector<double> layer_s;
  /// time at which each line's last move ends, from the program's start; indexed by line
  std::vector<double> line_end_s;
  int64_t moves = 0;  ///< number of straight moves; arcs count by their chords
  // Events of unknown duration, counted as 0 s.
  int64_t homings = 0;
  int64_t heat_waits = 0;  ///< waits for heat with an unknown rate
  int64_t tool_changes = 0;

  double TotalS() const { return move_s + dwell_s + heating_s; }
};

/// Returns the time of a whole program by the firmware's look-ahead. The machine stands still
/// before and after the program, and also stops at G4, G28, waits and tool changes. Unreadable
/// lines have no effect. Cost: O(bytes). Memory: O(longest sequence of moves without a retraction
/// or a stop).
ProgramTime TimeOfProgram(std::string_view gcode, const Firmware& firmware,
                          const MachineSetup& setup);

}  // namespace slicefarm::motion
