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

/// The way from the end of a pass to the beginning of the next one, over all that stands.
struct PassChange {
  size_t layer = 0;  ///< the pass's first, among the summary's
  Point from, to;    ///< as LayerSummary::exit and entry
  Coord top_nm = 0;    ///< of all that is printed before
  bool on_bed = true;  ///< the pass begins on the bed, not on a raft
};

/// Those of a program, in the order of printing.
std::vector<PassChange> PassChanges(const ProgramSummary& summary);

/// At what height nothing that reaches `top_nm` is in the way: 1 mm above, but not above
/// max_print_height.
Coord ClearHeight(Coord top_nm, const MotionOptions& options);

/// `G1 Z..`, z_offset included.
std::string MoveToHeight(Coord z_nm, const MotionOptions& options);

/// From the canonical state at the end of a pass to that over the entry of the next one, whose
/// program moves down first. The nozzle rises, runs `custom`, between_objects_gcode filled in, and
/// goes to the entry at that height, wherever that G-code has left it. The first layer's
/// temperatures are set and not waited for, unless that G-code sets them.
std::string GcodeOf(const PassChange& change, std::string_view custom,
                    const MotionOptions& options);

}  // namespace slicefarm::motion
