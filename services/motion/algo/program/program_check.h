#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/polygon.h"
#include "services/motion/algo/program/gcode_machine.h"

namespace slicefarm::motion {

/// Printer that a program is checked against.
struct CheckSetup {
  MachineSetup machine;
  double nozzle_mm = 0.4;
  double filament_mm = 1.75;  ///< diameter of the filament
  double z_offset_mm = 0;
  Polygon bed;               ///< printable area in nm; empty: not known
  double max_height_mm = 0;  ///< 0: not known
};

/// Error in a program.
struct Finding {
  int64_t line = 0;  ///< line number, from 1
  std::string text;

  friend bool operator==(const Finding&, const Finding&) = default;
};

/// Result of CheckProgram.
struct ProgramReport {
  std::vector<Finding> findings;  ///< in the order of their lines, at most kMostFindings
  int64_t found = 0;              ///< number of all errors, even if above kMostFindings
  int64_t lines = 0;
  int64_t moves = 0;
  /// Length of filament that the slicer prints: extrusions less retractions, without custom code.
  double filament_mm = 0;
};

inline constexpr size_t kMostFindings = 1000;

/// Reads a program strictly, as its firmware would, and reports errors:
/// - unreadable words, moves with a word without a number, speeds not above 0;
/// - commands that the firmware does not support (except macros in custom G-code);
/// - moves beyond bed and height (custom G-code may prime up to kCustomMarginMm beside the bed);
/// - beads with a cross-section above four times the nozzle diameter squared;
/// - filament moves longer than the firmware accepts;
/// - arcs with different radii at their ends, or in a form that the firmware does not accept;
/// - printing while retracted, restarts without a retraction;
/// - extrusion before a temperature is set;
/// - a sum of filament that differs from `; filament used [mm]`.
///
/// Custom G-code is all code under ;TYPE:Custom and all code before the first layer. Cost:
/// O(bytes).
ProgramReport CheckProgram(std::string_view gcode, const Firmware& firmware,
                           const CheckSetup& setup);

/// Distance from the bed within which custom G-code may move outside of it: the start G-code of
/// some printers does.
inline constexpr double kCustomMarginMm = 10;

}  // namespace slicefarm::motion
