#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "common/model/fields/density_field.h"
#include "services/infill/algo/fields/layer_field.h"

namespace slicefarm::infill {

/// Which of `width` x `height` cells are on, so that their share is that of `wanted`, in [0, 1], all
/// around. Floyd and Steinberg's error diffusion, row by row: 7/16 to the next cell, 3, 5, 1 / 16 to
/// the row after, before, below and beyond it. What would leave the cells, or go to cells that are
/// not `used`, is shared out among those neighbours that are; what the last cells are left with is made
/// good where the choice was closest. So the number of cells that are on is right to one half. `used`: empty for all.
std::vector<char> FloydSteinberg(const std::vector<double>& wanted, const std::vector<char>& used,
                                 int64_t width, int64_t height);

/// The part of `region` that is to be filled as densely as `greatest`, so that the average is the
/// field's: whole cells of the field's `cell_mm`, on a grid through the object's origin.
/// Cells that the region only touches count by the field alone.
/// Errors: REQUEST_TOO_LARGE for more than kMaxFieldCells. Cost: O(n log n + cells).
absl::StatusOr<MultiPolygon> DitheredRegion(const MultiPolygon& region, const LayerField& field,
                                            Dither dither, double greatest, double cell_mm);

}  // namespace slicefarm::infill
