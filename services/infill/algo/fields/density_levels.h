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

/// Ratio of each level to the next higher level.
inline constexpr double kLevelStep = 0.70710678118654752;
/// Lower limit of the levels. A point with a lower density is filled with the lowest level, or not
/// at all.
inline constexpr double kLeastLevel = 0.01;
/// Period of the height over which points between two levels change from one level to the other and
/// back.
inline constexpr double kLevelSwingMm = 4;

/// Divides a region into parts with constant density, for patterns with lines that cannot be
/// graded. The levels are the field's greatest density, and this density multiplied repeatedly by
/// kLevelStep.
///
/// A point between two levels is filled with one of them. A threshold, common to all cells of a
/// layer, decides which one. The threshold changes with the height, so that over a period each
/// level is used for the right share of the height. The mean density is then exactly the field's
/// density, and parts are not split up within a layer. Boundaries of parts follow the edges of
/// cells with the side `cell_mm`. A cell has the field's value in its middle.
///
/// Errors: REQUEST_TOO_LARGE for more than kMaxFieldCells. Cost: O(levels (n log n + cells)), n
/// points of the region.
absl::StatusOr<std::vector<DensityPart>> LevelParts(const MultiPolygon& region,
                                                    const LayerField& field, double cell_mm);

}  // namespace slicefarm::infill
