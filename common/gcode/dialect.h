#pragma once

#include <cstdint>
#include <string_view>

#include "common/gcode/gcode_text.h"

namespace slicefarm::gcode {

/// Whose G-code a program without filament is in: what cuts or burns.
enum class Controller : uint8_t { kMarlin, kGrbl, kLinuxCnc };

/// What controllers want differently. What differs between printers' firmware is motion's
/// (services/motion/algo/firmware).
struct Dialect {
  std::string_view name;
  bool has_feed_modes = true;   ///< G93 and G94
  bool has_program_end = true;  ///< M2
  bool has_tool_table = false;  ///< M6 changes tools, G43 knows their lengths
  bool has_blending = false;    ///< G64 P bounds how corners are rounded
  bool inline_power = false;    ///< S goes with the moves it stands in: I of M3 to M5
  bool dwells_in_ms = false;    ///< P of G4, else seconds
};

/// Sources: Marlin 2.1 (marlinfw.org/docs/gcode), grbl 1.1 (doc/markdown/commands.md), LinuxCNC 2.9
/// ("G-Codes", "M-Codes" of its manual).
const Dialect& DialectOf(Controller controller);

/// Millimetres, absolute places, and where there are such modes feeds in mm/min: one word a line.
void WriteUnits(const Dialect& dialect, GcodeText& out);

/// Stands still for that long, where it counts milliseconds at least so long. REQUIRES: us > 0.
void WriteDwell(const Dialect& dialect, double us, GcodeText& out);

void WriteProgramEnd(const Dialect& dialect, GcodeText& out);

}  // namespace slicefarm::gcode
