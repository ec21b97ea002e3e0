#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/fields/layer_field.h"

namespace slicefarm::infill {

/// Part of a region that is filled with one density.
struct DensityPart {
  MultiPolygon area;
  double density = 0;
};

/// Ratio of each density level to the next higher level.
inline constexpr double kLevelStep = 0.70710678118654752;
/// Smallest density level. A point with a lower density is filled with the lowest level at some
/// heights, and stays empty at the other heights.
inline constexpr double kLeastLevel = 0.01;
/// Period in z, in mm. In each period, a point with a density between two levels changes from one
/// level to the other and back.
inline constexpr double kLevelSwingMm = 4;

/// Divides a region into parts with constant density, for patterns with lines that cannot be
/// graded. The highest level is the field's greatest density; each further level is kLevelStep
/// times the level above it.
///
/// A point with a density between two levels is filled with one of these levels. A threshold,
/// common to all cells of a layer, decides which one. The threshold changes with the height, so
/// that over a period each level is used for the right share of the height. The mean density is
/// then exactly the field's density, and parts are not split up within a layer. Boundaries of parts
/// follow the edges of square cells with the side `cell_mm`. Each cell has the density of its
/// middle. A point that stays empty is in no part.
///
/// Errors: REQUEST_TOO_LARGE for more than kMaxFieldCells. Cost: O(levels (n log n + cells)), n
/// points of the region.
absl::StatusOr<std::vector<DensityPart>> LevelParts(const MultiPolygon& region,
                                                    const LayerField& field, double cell_mm);

}  // namespace slicefarm::infill
