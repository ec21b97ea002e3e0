#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Where seams lie in a layer. All places of a period come in turn, as evenly as can be at any
/// number of layers (low-discrepancy sequences), so that no column of a part has a seam in each
/// layer.

/// By how much the lines and cells of a layer's hatch are moved; 0 in layer 0, and without
/// options.shift_grids.
Point GridShift(int32_t layer, double angle_deg, const ExposureOptions& options);

/// How many lines along the innermost contour a layer's hatch has, beyond which its lines end: by
/// turns none to kBorderTurns - 1, so that the strip where lines and what they end at are melted
/// twice lies elsewhere. 0 without options.shift_grids, where hatch keeps off the contour or there
/// is none, and of rings, which run along the contour anyway.
int32_t BorderLines(int32_t layer, const ExposureOptions& options);
inline constexpr int32_t kBorderTurns = 6;

/// Which of a piece's rings do what cannot be done without melting a place twice.
struct RingTurn {
  /// Every kCornerTurns-th ring reaches into corners, from this one on.
  int32_t corner = 0;
  /// At which share of the rings, in [0, 1), those deeper down lie nearer, so that the innermost
  /// has as much room as it melts.
  double nearer = 0;
};
RingTurn RingTurnOf(int32_t layer);
inline constexpr int32_t kCornerTurns = 5;

/// At which share of a piece's outermost ring its rings begin, in [0, 1).
double RingStart(int32_t layer);

/// At which share of its length contour `number`, from 0, begins in a layer, in [0, 1).
double ContourShare(int32_t layer, int32_t number);

/// Which choice of cuts into convex pieces is taken: DecomposeOptions::variant.
int32_t CutVariant(int32_t layer, const ExposureOptions& options);

}  // namespace slicefarm::exposure
