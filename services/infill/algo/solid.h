#pragma once

#include <optional>

#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "common/model/options/surface_options.h"

namespace slicefarm::infill {

/// Parameters of FillSolid.
struct SolidFill {
  Feature feature = Feature::kSolidInfill;
  FillPattern pattern = FillPattern::kMonotonic;
  double angle_rad = 0;
  Coord width_nm = 450'000;
  Coord height_nm = 200'000;
  int32_t layer = 0;  ///< index of the layer in the object
  /// Distance by which lines may be nearer to the region's boundary than half a spacing. Beside
  /// walls, the ends of straight lines also cover about two thirds of the distance that remains to
  /// the boundary.
  Coord overlap_nm = 0;
  /// True if walls surround the region. Then ends of lines may reach into the walls.
  bool beside_walls = true;
  /// True if straight lines and their links end on the region's boundary, for lines in the air.
  /// Then half of a line's width at the boundary is supported by the area beside the region.
  bool anchored = false;
  /// Order of loops and turns, for patterns with a middle (HasMiddle). With an order, they are not
  /// linked to each other, and the group keeps its order.
  FillOrder order = FillOrder::kNearest;
  /// Middle of spirals, in the object's frame; nullopt: the middle of the region
  std::optional<Point> center = Point{};
};

/// Returns true if lines of the pattern have an order from the middle to the edge.
bool HasMiddle(FillPattern pattern);

/// Returns true if lines of the pattern keep their direction from layer to layer.
bool IsAligned(FillPattern pattern);

/// Covers one connected region with beads side by side.
///
/// For lines and loops, a whole number of beads fits across the region. The spacing is therefore up
/// to 15 % less or 20 % more than the spacing of `width_nm`, and the beads' width follows. The
/// volume of the beads equals the region's volume within 1.25 %, except for regions of a few lines.
/// The section of a straight line beside walls changes by at most 30 % from end to end, and the
/// line is never narrower than 0.6 spacings. The links between lines fill the area before the
/// boundary that the lines' ends leave empty, with 0.15 of a line's plastic.
///
/// Order of paths: with kMonotonic, each piece of line follows the pieces beside it on the previous
/// line, and the group keeps its order. With kMonotonicLines the order is the same, but each piece
/// is a separate path. For other straight lines, any order. SolidFill::order gives loops and
/// spirals an order. Loops, spirals and space-filling curves have the form of the sparse patterns,
/// at full density. Their lines end at the region's boundary, and leave narrow parts beside it
/// empty.
///
/// Errors: REQUEST_TOO_LARGE for too many lines (CutLines, MakePattern); SETTING_OUT_OF_RANGE
/// (CheckRingSpacing). Cost: O(n log n) for the inset, n points, and the cost of the pattern.
/// REQUIRES: the pattern is a pattern for solid fill.
absl::StatusOr<FillGroup> FillSolid(const PolygonWithHoles& region, const SolidFill& fill);

}  // namespace slicefarm::infill
