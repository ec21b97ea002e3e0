#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/vector.h"

namespace slicefarm::cli {

/// Consecutive extruding moves with the same feature, width and speed.
struct BeadRun {
  std::string feature;  ///< text of `;TYPE:`
  double width_mm = 0;
  std::vector<Vector2> points;  ///< at least two
  double speed_mm_s = 0;        ///< speed in the G-code; 0: none
  double flow_mm3_s = 0;        ///< flow at this speed
  double energy_j_mm = 0;       ///< exposure energy per mm; 0: not known
  /// Start time, counted from the start of the layer's first bead; computed from `line_end_s`.
  double time_s = 0;
};

/// One layer of a G-code file, from its moves and comments.
struct GcodeLayer {
  int index = 0;  ///< number of the layer, counted from 0
  int layer_count = 0;
  double z_mm = 0;
  double height_mm = 0;
  std::vector<BeadRun> beads = {};
  std::vector<std::vector<Vector2>> travels = {};
};

/// Reads layer `index` of a program with PrusaSlicer's comments (;LAYER_CHANGE ;Z: ;HEIGHT: ;TYPE:
/// ;WIDTH:), which slicefarm writes too. The flow is computed with the filament diameter in `;
/// filament_diameter = `, or with 1.75 mm without this comment. `line_end_s`: end time of each line
/// of the file (ProgramTime). If it is given, each run contains the beads of one line only.
///
/// Supports G0 to G3 (arcs as short chords), G90, G91, G92, M82 and M83. Ignores invalid numbers:
/// not finite, beyond 1e9, and widths not above 0. Errors: REQUEST_MALFORMED, with the last layer
/// if there is no layer `index`, or if there is no ;LAYER_CHANGE at all. Cost: one pass over the
/// file.
absl::StatusOr<GcodeLayer> ReadGcodeLayer(std::string_view gcode, int index,
                                          std::span<const double> line_end_s = {});

}  // namespace slicefarm::cli
