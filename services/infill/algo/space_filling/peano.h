#pragma once

#include <cstdint>

#include "services/infill/algo/space_filling/curve_cell.h"

namespace slicefarm::infill {

/// Returns the cell at `index` of the Peano curve of `order`. The curve passes through a square of
/// 3^order x 3^order cells, from (0, 0) to the opposite corner, upwards first. Of the index's
/// ternary digits t1 t2 t3 .., the odd ones belong to x and the even ones to y. A digit is mirrored
/// (2 - t) if the sum of the preceding digits of the other axis is odd. REQUIRES: order in [0, 20];
/// index < 9^order. Cost: O(order).
CurveCell PeanoCell(int order, uint64_t index);

/// Returns the index of a cell (the inverse of PeanoCell).
uint64_t PeanoIndex(int order, CurveCell cell);

}  // namespace slicefarm::infill
