#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Positions of seams (starts, cuts and areas melted twice) in a layer. The layers use all
/// positions of a period one after the other, as evenly as possible for any number of layers
/// (low-discrepancy sequences). Therefore no vertical line through a part has a seam in each layer.

/// Returns the shift of the lines and cells of a layer's hatch. It is 0 in layer 0, and without
/// options.shift_grids.
Point GridShift(int32_t layer, double angle_deg, const ExposureOptions& options);

/// Returns the number of hatch lines along the innermost contour, at which the other lines of a
/// layer's hatch end. The number changes from layer to layer, from 0 to kBorderTurns - 1, so that
/// the strip that is melted twice at the ends of lines is at different positions. It is 0 without
/// options.shift_grids, if the hatch's spots do not overlap the contour, if there is no contour,
/// and for rings, which are always parallel to the contour.
int32_t BorderLines(int32_t layer, const ExposureOptions& options);
inline constexpr int32_t kBorderTurns = 6;

/// Choice of the rings of a piece that melt some area twice, because this is inevitable: the rings
/// that reach into corners, and the ring from which deeper rings are shifted. The choice changes
/// from layer to layer.
struct RingTurn {
  /// Index of the first ring that reaches into corners, and so does every kCornerTurns-th ring
  /// after it.
  int32_t corner = 0;
  /// Fraction of the rings, in [0, 1), after which deeper rings are shifted outwards, so that the
  /// area left for the innermost ring is exactly the area that it melts.
  double nearer = 0;
};
/// Returns the ring choice of a layer.
RingTurn RingTurnOf(int32_t layer);
inline constexpr int32_t kCornerTurns = 5;

/// Returns the fraction of the length of a piece's outermost ring at which the piece's rings begin,
/// in [0, 1).
double RingStart(int32_t layer);

/// Returns the fraction of its length, in [0, 1), at which contour `number` (from 0) begins in a
/// layer.
double ContourShare(int32_t layer, int32_t number);

/// Returns the choice of cuts into convex pieces: DecomposeOptions::variant.
int32_t CutVariant(int32_t layer, const ExposureOptions& options);

}  // namespace slicefarm::exposure
