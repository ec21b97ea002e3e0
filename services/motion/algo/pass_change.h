#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "common/model/layers/program_summary.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Travel from the end of a pass to the start of the next one, above everything that is printed.
struct PassChange {
  size_t layer = 0;  ///< index in the summary of the new pass's first layer
  /// LayerSummary::exit of the last layer, and LayerSummary::entry of the next one
  Point from, to;
  Coord top_nm = 0;    ///< top of everything that earlier passes have printed
  bool on_bed = true;  ///< true if the new pass begins on the bed; false: on a raft
};

/// Returns the pass changes of a program, in the order of printing.
std::vector<PassChange> PassChanges(const ProgramSummary& summary);

/// Returns the height at which the nozzle travels above everything up to `top_nm`: 1 mm higher, but
/// not above max_print_height.
Coord ClearHeight(Coord top_nm, const MotionOptions& options);

/// Returns a line `G1 Z..` that moves to `z_nm` plus the setting z_offset.
std::string MoveToHeight(Coord z_nm, const MotionOptions& options);

/// Returns the G-code between two passes. It begins in the canonical state at the end of a pass,
/// and ends above the entry of the next pass, which then moves down. `custom`: the filled-in
/// between_objects_gcode.
///
/// The nozzle rises to ClearHeight and runs `custom`. Then it travels at this height to the entry,
/// from the position in which `custom` ends. If the next pass begins on the bed, the first layer's
/// temperatures are set without a wait, unless `custom` sets temperatures.
std::string GcodeOf(const PassChange& change, std::string_view custom,
                    const MotionOptions& options);

}  // namespace slicefarm::motion
