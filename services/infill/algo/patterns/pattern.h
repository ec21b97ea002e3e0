#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

/// Where a pattern is laid out, and how dense. All in the object's own frame, around its origin, so
/// that a pattern is the same in all layers, islands and copies.
struct PatternPlace {
  Coord z_nm = 0;  ///< of the layer's middle, above the object's bottom
  int32_t layer = 0;
  double pitch_nm = 0;  ///< the law: length of lines per area is 1 / pitch, over a period in z
  double angle_rad = 0;
  Coord spacing_nm = 0;  ///< of beads that lie side by side
  /// Of patterns that lie along the region's edge: how far inside it the outermost line is, in
  /// pitches. Half of one if they are to fill the region, 0 if that line is to hold to the walls.
  double first_line = 0.5;
  std::span<const Polyline> planned = {};  ///< the lines of patterns that planning lays out
  Coord smoothing_nm = 0;                  ///< of lines that follow the region; 0: none
};

/// What is left of a pattern inside a region. Every pattern has this form; registry.h names them.
/// A pattern may have pieces on top of each other only where the law says so (crossing lines).
/// Errors: REQUEST_TOO_LARGE with `limit` and `got`, for more lines than limits::kMaxLinesPerFill.
using MakePattern = absl::StatusOr<std::vector<Piece>>(const MultiPolygon& region,
                                                       const PatternPlace& place);

}  // namespace slicefarm::infill
