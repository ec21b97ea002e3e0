#pragma once

#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"

namespace slicefarm::infill {

struct SolidFill {
  Feature feature = Feature::kSolidInfill;
  FillPattern pattern = FillPattern::kMonotonic;
  double angle_rad = 0;
  Coord width_nm = 450'000;
  Coord height_nm = 200'000;
  int32_t layer = 0;  ///< of the object's own
  /// How much nearer than half a spacing lines come to the region's edge. Beside walls, the ends of
  /// straight lines go about two thirds of the way that is left, too.
  Coord overlap_nm = 0;
  bool beside_walls = true;  ///< they lie around the region: ends of lines may reach into them
  /// Straight lines end, and links run, on the region's edge: threads in the air hold by half of
  /// their width to what lies beside them.
  bool anchored = false;
};

/// Whether a pattern's lines run the same way in all layers.
bool IsAligned(FillPattern pattern);

/// Covers one connected region with beads side by side. For lines and loops the spacing is the
/// nearest to that of `width_nm` that fits a whole number of beads across the region, within 15 %
/// less and 20 % more; the beads' width follows, and the volume is the region's within 1.25 %, but
/// for regions of a few lines. No straight line beside walls changes its section by more than 30 %
/// from edge to edge, or is narrower than 0.6 spacings. The links between them hold what the
/// lines' ends lack of the room before the edge: 0.15 of a line's plastic.
///
/// Monotonic: each piece of line after those of the line before that it lies beside; the group
/// keeps its order. Monotonic lines: the same, each a path of its own. Other straight lines: any
/// order. Loops, spirals and space-filling curves: as the sparse pattern, at full density; curves
/// end where the region does, and leave out what is narrower there than they are.
/// Errors: as CutLines and MakePattern. Cost: O(n log n) for the inset, and the pattern's own.
/// REQUIRES: the pattern is one for solid fill.
absl::StatusOr<FillGroup> FillSolid(const PolygonWithHoles& region, const SolidFill& fill);

}  // namespace slicefarm::infill
