#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/vector.h"

namespace slicefarm::cli {

/// Consecutive extruding moves of one feature, width and speed.
struct BeadRun {
  std::string feature;  ///< the words of `;TYPE:`
  double width_mm = 0;
  std::vector<Vector2> points;  ///< at least two
  double speed_mm_s = 0;        ///< as the G-code asks for it; 0: it does not
  double flow_mm3_s = 0;        ///< at that speed
  double energy_j_mm = 0;       ///< of exposure, on a mm of way; 0: not known
  double time_s = 0;  ///< when it is laid, from the layer's first bead on; by `line_end_s`
};

/// One layer of a G-code file, as its moves and comments tell.
struct GcodeLayer {
  int index = 0;  ///< from 0
  int layer_count = 0;
  double z_mm = 0;
  double height_mm = 0;
  std::vector<BeadRun> beads = {};
  std::vector<std::vector<Vector2>> travels = {};
};

/// Reads layer `index` of a program with PrusaSlicer's comments (;LAYER_CHANGE ;Z: ;HEIGHT: ;TYPE:
/// ;WIDTH:), which is what slicefarm writes; flow by `; filament_diameter = `, else 1.75 mm.
/// Follows G0 to G3 (arcs as short chords), G90, G91, G92, M82 and M83; passes over numbers that no
/// printer has: not finite, beyond 1e9, and widths not above 0. Errors: REQUEST_MALFORMED naming
/// the last layer, or if there is no ;LAYER_CHANGE at all. Cost: one pass over the file.
/// `line_end_s`: when each line of the file has ended (ProgramTime); beads are then runs of one
/// line.
absl::StatusOr<GcodeLayer> ReadGcodeLayer(std::string_view gcode, int index,
                                          std::span<const double> line_end_s = {});

}  // namespace slicefarm::cli
