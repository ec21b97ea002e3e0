#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/fields/layer_field.h"

namespace slicefarm::infill {

/// Densities of a field in square cells, on a grid through the object's origin. The cells are the
/// grid's rectangle around a region, row by row.
struct FieldCells {
  /// index of the first cell in x and y, counted from the origin
  int64_t first_x = 0, first_y = 0;
  int64_t width = 0, height = 0;
  Coord cell_nm = 1;
  std::vector<double> density;  ///< density in the middle of each cell
  std::vector<char> touched;    ///< not 0 if the cell and the region overlap
};

/// Returns the cells with the side `cell_mm` around the region, with the field's densities. Errors:
/// REQUEST_TOO_LARGE for more than kMaxFieldCells. Cost: O(n log n + cells), n points of the
/// region.
absl::StatusOr<FieldCells> FieldCellsOf(const MultiPolygon& region, const LayerField& field,
                                        double cell_mm);

/// Returns the part of the region in the cells for which `on` is not 0. Cost: O(n log n + cells), n
/// points of the region.
MultiPolygon PartInCells(const MultiPolygon& region, const FieldCells& cells, std::vector<char> on);

}  // namespace slicefarm::infill
