#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

// Positions of seams in a layer: starts of lines, cuts between pieces, and areas melted twice.
// From layer to layer, each seam moves through all positions of a period, as evenly as possible
// for any number of layers (low-discrepancy sequences). Therefore no vertical line through a part
// has a seam in each layer.

/// Returns the shift of the lines and cells of a layer's hatch. It is 0 in layer 0, and without
/// options.shift_grids.
Point GridShift(int32_t layer, double angle_deg, const ExposureOptions& options);

/// Returns the number of border lines: hatch lines along the innermost contour at which the other
/// hatch lines of a layer end. The number changes from layer to layer, from 0 to kBorderTurns - 1.
/// So the strip that is melted twice at the ends of lines moves. The number is 0 in these cases:
/// - options.shift_grids is off;
/// - there is no contour, or the hatch's spots do not overlap it;
/// - the strategy is rings, which are always parallel to the contour.
int32_t BorderLines(int32_t layer, const ExposureOptions& options);
inline constexpr int32_t kBorderTurns = 6;

/// Rings of a piece that melt some area twice, which is inevitable: rings that reach into corners,
/// and the ring from which deeper rings are shifted. Other rings are chosen in each layer.
struct RingTurn {
  /// Index of the first ring that reaches into corners. Every kCornerTurns-th ring after it does
  /// too.
  int32_t corner = 0;
  /// Fraction of the rings, in [0, 1), after which deeper rings are shifted outwards. After the
  /// shift, the area left for the innermost ring is exactly the area that this ring melts.
  double nearer = 0;
};
/// Returns the rings of a layer that melt some area twice.
RingTurn RingTurnOf(int32_t layer);
inline constexpr int32_t kCornerTurns = 5;

/// Returns the start of a piece's rings in a layer, as a fraction of the length of its outermost
/// ring, in [0, 1).
double RingStart(int32_t layer);

/// Returns the start of contour `number` (from 0, from outside) in a layer, as a fraction of the
/// contour's length, in [0, 1).
double ContourShare(int32_t layer, int32_t number);

/// Returns DecomposeOptions::variant for a layer: 0 without options.turn_rings, else 0, 1 and 2 in
/// turn.
int32_t CutVariant(int32_t layer, const ExposureOptions& options);

}  // namespace slicefarm::exposure
