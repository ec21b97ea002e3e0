#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "services/motion/algo/program/gcode_machine.h"

namespace slicefarm::motion {

/// What a program takes. Times in s.
struct ProgramTime {
  double move_s = 0;   ///< of all moves
  double dwell_s = 0;  ///< G4
  double heating_s = 0;  ///< waits for heat whose rate is known
  /// Of what is printed, by the words of the slicer's comments ("None" without).
  std::map<std::string, double> feature_s;
  double travel_s = 0;   ///< of what moves without printing
  double retract_s = 0;  ///< of filament alone
  double before_s = 0;   ///< moves and dwells before the first layer's comment
  std::vector<double> layer_s;
  std::vector<double> line_end_s;  ///< by line: when its moves have ended, from the program's start
  int64_t moves = 0;  ///< straight ones; arcs count by their chords
  // What takes a time that no program tells: counted as 0 s.
  int64_t homings = 0;
  int64_t heat_waits = 0;  ///< of unknown rate
  int64_t tool_changes = 0;

  double TotalS() const { return move_s + dwell_s + heating_s; }
};

/// The time of a whole program by the firmware's look-ahead, from rest to rest and wherever the
/// machine has to stop in between (G4, G28, waits, tool changes). Lines that cannot be read do
/// nothing. Cost: O(bytes); memory: of the longest run without a retraction or a stop.
ProgramTime TimeOfProgram(std::string_view gcode, const Firmware& firmware,
                          const MachineSetup& setup);

}  // namespace slicefarm::motion
