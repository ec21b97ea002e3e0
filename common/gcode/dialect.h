#pragma once

#include <cstdint>
#include <string_view>

#include "common/gcode/gcode_text.h"

namespace slicefarm::gcode {

/// Controller of a machine without filament. The controller determines the G-code dialect.
enum class Controller : uint8_t { kMarlin, kGrbl, kLinuxCnc };

/// Commands that a controller supports, as far as controllers differ. Differences between the
/// firmwares of printers are handled by motion (services/motion/algo/firmware).
struct Dialect {
  std::string_view name;
  bool has_feed_modes = true;   ///< true if the controller has G93 and G94
  bool has_program_end = true;  ///< true if the controller has M2
  bool has_tool_table = false;  ///< true if M6 changes tools and G43 applies their lengths
  bool has_blending = false;    ///< true if G64 P limits the rounding of corners
  /// true if S in a move sets the power for this move (M3 to M5 with word I)
  bool inline_power = false;
  bool dwells_in_ms = false;  ///< unit of G4's P: true: ms, false: s
};

/// Returns the dialect of a controller. Sources: Marlin 2.1 (marlinfw.org/docs/gcode), grbl 1.1
/// (doc/markdown/commands.md), LinuxCNC 2.9 ("G-Codes", "M-Codes" of its manual).
const Dialect& DialectOf(Controller controller);

/// Writes the commands for millimetres, absolute positions, and, if the dialect has feed modes,
/// feeds in mm/min: one command per line.
void WriteUnits(const Dialect& dialect, GcodeText& out);

/// Writes a dwell (G4) of `us` microseconds. A dwell in ms is rounded up to whole milliseconds.
/// REQUIRES: us > 0.
void WriteDwell(const Dialect& dialect, double us, GcodeText& out);

/// Writes the end of the program: M2, if the dialect has it.
void WriteProgramEnd(const Dialect& dialect, GcodeText& out);

}  // namespace slicefarm::gcode
