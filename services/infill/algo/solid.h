#pragma once

#include "absl/status/statusor.h"
#include "common/model/infill_options.h"
#include "common/model/layer.h"

namespace slicefarm::infill {

struct SolidFill {
  Feature feature = Feature::kSolidInfill;
  SolidPattern pattern = SolidPattern::kMonotonic;
  double angle_rad = 0;
  Coord width_nm = 450'000;
  Coord height_nm = 200'000;
  Coord overlap_nm = 0;  ///< how much nearer than half a spacing lines come to the region's edge
};

/// Covers one connected region with beads side by side. The spacing is the nearest to that of
/// `width_nm` that fits a whole number of beads across the region, within 15 % less and 20 % more;
/// the beads' width follows, so that the volume is exact.
///
/// Monotonic: each piece of line after those of the line before that it lies beside; the group
/// keeps its order. Rectilinear: any order. Errors: as CutLines. Cost: O(n log n) for the inset,
/// O(n + k log k) for the lines.
absl::StatusOr<FillGroup> FillSolid(const PolygonWithHoles& region, const SolidFill& fill);

}  // namespace slicefarm::infill
