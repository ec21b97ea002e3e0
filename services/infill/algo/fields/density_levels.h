#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/fields/layer_field.h"

namespace slicefarm::infill {

/// A part of a region that is filled with one density.
struct DensityPart {
  MultiPolygon area;
  double density = 0;
};

/// Each level is so much of the next one.
inline constexpr double kLevelStep = 0.70710678118654752;
/// The lowest level is no lower; below it a place is filled with that, or not at all.
inline constexpr double kLeastLevel = 0.01;
/// The height over which places between two levels go from the one to the other and back.
inline constexpr double kLevelSwingMm = 4;

/// Parts a region where the field falls from level to level, for patterns whose lines cannot be
/// graded: the levels are the greatest density and kLevelStep of it, again and again.
///
/// Places between two levels are filled with either, by a threshold that all cells of a layer
/// share. It swings with the height, so each place has either for the share of the height that
/// makes it as dense as the field asks for: exactly over a swing, and parts stay whole in each
/// layer. Edges of parts are those of cells of `cell_mm`, the field's value is that in their
/// middles.
///
/// Errors: as FieldCellsOf. Cost: O(levels (n log n + cells)).
absl::StatusOr<std::vector<DensityPart>> LevelParts(const MultiPolygon& region,
                                                    const LayerField& field, double cell_mm);

}  // namespace slicefarm::infill
