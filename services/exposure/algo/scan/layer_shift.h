#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Positions of seams in a layer. All positions of a period are used one after the other, as evenly
/// as possible for any number of layers (low-discrepancy sequences). Therefore no column of a part
/// has a seam in each layer.

/// Returns the shift of the lines and cells of a layer's hatch. It is 0 in layer 0, and without
/// options.shift_grids.
Point GridShift(int32_t layer, double angle_deg, const ExposureOptions& options);

/// Returns the number of hatch lines along the innermost contour, at which the other lines of a
/// layer's hatch end. It alternates from 0 to kBorderTurns - 1, so that the strip that is melted
/// twice at the ends of lines is at different positions. It is 0 without options.shift_grids, if
/// hatch keeps off the contour, if there is no contour, and for rings, which run along the contour
/// in any case.
int32_t BorderLines(int32_t layer, const ExposureOptions& options);
inline constexpr int32_t kBorderTurns = 6;

/// Choice of a piece's rings for tasks that inevitably melt some area twice.
struct RingTurn {
  /// First ring that reaches into corners; every kCornerTurns-th ring after it does so too.
  int32_t corner = 0;
  /// Share of the rings, in [0, 1), after which deeper rings are shifted outwards, so that the
  /// innermost ring has exactly the area that it melts.
  double nearer = 0;
};
/// Returns the ring choice of a layer.
RingTurn RingTurnOf(int32_t layer);
inline constexpr int32_t kCornerTurns = 5;

/// Returns the share of a piece's outermost ring at which its rings begin, in [0, 1).
double RingStart(int32_t layer);

/// Returns the share of its length at which contour `number` (from 0) begins in a layer, in [0, 1).
double ContourShare(int32_t layer, int32_t number);

/// Returns the choice of cuts into convex pieces: DecomposeOptions::variant.
int32_t CutVariant(int32_t layer, const ExposureOptions& options);

}  // namespace slicefarm::exposure
