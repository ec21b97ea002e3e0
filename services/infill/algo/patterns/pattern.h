#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "common/model/options/pattern_options.h"
#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

/// Position and density of a pattern. All values are in the object's own frame, around its origin.
/// A pattern is therefore the same in all layers, islands and copies.
struct PatternContext {
  Coord z_nm = 0;  ///< height of the layer's middle above the object's bottom
  int32_t layer = 0;
  /// pitch in nm: the length of lines per area is 1 / pitch, on average over a period in z
  double pitch_nm = 0;
  double angle_rad = 0;
  Coord spacing_nm = 0;  ///< spacing of beads side by side (bead_section.h)
  /// Distance from the region's boundary to the outermost line, in pitches, for patterns along the
  /// boundary. With 0.5 the lines fill the region. With 0 the outermost line sticks to the walls.
  double first_line = 0.5;
  std::span<const Polyline> planned = {};  ///< lines of patterns that planning lays out
  /// length in nm over which lines that follow the region are smoothed; 0: none
  Coord smoothing_nm = 0;
  PatternOptions shape = {};
};

/// Function that returns the parts of a pattern inside a region. Every pattern has this form;
/// registry.h maps patterns to functions. Pieces may overlap only where the pattern's definition
/// requires it (crossing lines). Errors: REQUEST_TOO_LARGE with `limit` and `got`, for more lines
/// than limits::kMaxLinesPerFill.
using MakePattern = absl::StatusOr<std::vector<Piece>>(const MultiPolygon& region,
                                                       const PatternContext& context);

}  // namespace slicefarm::infill
