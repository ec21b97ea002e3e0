#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "common/model/fields/density_field.h"
#include "services/infill/algo/fields/layer_field.h"

namespace slicefarm::infill {

/// Returns a flag for each cell of a grid of `width` x `height` cells: not 0 if the cell is on.
/// `wanted`: requested share of cells that are on, in [0, 1], for each cell. In every part of the
/// area the share of cells that are on is approximately the requested share. This is Floyd and
/// Steinberg's error diffusion, row by row: 7/16 of the error is added to the next cell, and 3/16,
/// 5/16, 1/16 to three cells of the next row (before, below and after this cell).
///
/// Errors are not passed on to cells outside of the grid or not `used`: the remaining neighbours
/// get their shares. The error left at the last cells is corrected at the cells with the closest
/// decision. The number of cells that are on is therefore correct to one half. `used`: empty if all
/// cells are used.
std::vector<char> FloydSteinberg(const std::vector<double>& wanted, const std::vector<char>& used,
                                 int64_t width, int64_t height);

/// Returns the part of `region` that is filled with the density `greatest`, so that the average is
/// the field's density. The part consists of whole cells with the side `cell_mm`, on a grid through
/// the object's origin. Cells at the region's boundary are decided by the field alone, not by their
/// share inside. Errors: REQUEST_TOO_LARGE for more than kMaxFieldCells. Cost: O(n log n + cells),
/// n points of the region.
absl::StatusOr<MultiPolygon> DitheredRegion(const MultiPolygon& region, const LayerField& field,
                                            Dither dither, double greatest, double cell_mm);

}  // namespace slicefarm::infill
