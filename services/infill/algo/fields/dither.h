#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "common/model/fields/density_field.h"
#include "services/infill/algo/fields/layer_field.h"

namespace slicefarm::infill {

/// Returns a flag for each cell of a grid of `width` x `height` cells, row by row: not 0 if the
/// cell is on. `wanted`: for each cell, the requested share of cells that are on, in [0, 1]. In
/// every part of the area the share of cells that are on is approximately the requested share. The
/// method is Floyd and Steinberg's error diffusion, row by row. The next cell gets 7/16 of a cell's
/// error. Three cells of the next row (before, below and after this cell) get 3/16, 5/16 and 1/16.
///
/// `used`: for each cell, not 0 if the cell may be on; empty: all cells. No error is passed to
/// unused cells or beyond the grid: the remaining neighbours share the whole error. Error that no
/// neighbour can take is corrected at the end, at the cells that were nearest to the threshold. The
/// total number of cells that are on is therefore correct to one half.
std::vector<char> FloydSteinberg(const std::vector<double>& wanted, const std::vector<char>& used,
                                 int64_t width, int64_t height);

/// Returns the part of `region` that is filled with the density `greatest`, so that the mean
/// density is the field's density. The part consists of whole square cells with the side `cell_mm`,
/// on a grid through the object's origin, cut by the region. A cell at the region's boundary is
/// treated as if all of it were inside. Errors: REQUEST_TOO_LARGE for more than kMaxFieldCells.
/// Cost: O(n log n + cells), n points of the region.
absl::StatusOr<MultiPolygon> DitheredRegion(const MultiPolygon& region, const LayerField& field,
                                            Dither dither, double greatest, double cell_mm);

}  // namespace slicefarm::infill
