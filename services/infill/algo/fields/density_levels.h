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
/// Height over which points between two levels change from one level to the other and back.
inline constexpr double kLevelSwingMm = 4;

/// Divides a region into parts with constant density, for patterns with lines that cannot be
/// graded. The levels are the greatest density, and this density multiplied repeatedly by
/// kLevelStep.
///
/// A point between two levels is filled with one of them, by a threshold that all cells of a layer
/// share. The threshold changes with the height. Each point therefore has either level for the
/// share of the height that gives the density of the field: exactly over a period, and parts are
/// not split up within a layer. Edges of parts are edges of cells of `cell_mm`. A cell has the
/// field's value in its middle.
///
/// Errors: as FieldCellsOf. Cost: O(levels (n log n + cells)).
absl::StatusOr<std::vector<DensityPart>> LevelParts(const MultiPolygon& region,
                                                    const LayerField& field, double cell_mm);

}  // namespace slicefarm::infill
