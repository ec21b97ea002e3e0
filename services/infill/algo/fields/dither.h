#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "common/model/fields/density_field.h"
#include "services/infill/algo/fields/layer_field.h"

namespace slicefarm::infill {

/// Selects the cells, of `width` x `height`, that are on, so that their share is the share of
/// `wanted`, in [0, 1], in all parts of the area. This is Floyd and Steinberg's error diffusion,
/// row by row: 7/16 to the next cell, and 3/16, 5/16, 1/16 to three cells of the next row (before,
/// below and after this cell).
///
/// Error that would leave the cells, or go to cells that are not `used`, is distributed to the
/// remaining neighbours. The error left at the last cells is corrected at the cells with the
/// closest decision. The number of cells that are on is therefore correct to one half. `used`:
/// empty if all cells are used.
std::vector<char> FloydSteinberg(const std::vector<double>& wanted, const std::vector<char>& used,
                                 int64_t width, int64_t height);

/// Returns the part of `region` that is filled with the density `greatest`, so that the average is
/// the field's density. The part consists of whole cells of the field's `cell_mm`, on a grid
/// through the object's origin. Cells that are only partly in the region count by the field alone.
/// Errors: REQUEST_TOO_LARGE for more than kMaxFieldCells. Cost: O(n log n + cells).
absl::StatusOr<MultiPolygon> DitheredRegion(const MultiPolygon& region, const LayerField& field,
                                            Dither dither, double greatest, double cell_mm);

}  // namespace slicefarm::infill
