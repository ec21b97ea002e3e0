#pragma once

#include <cstdint>

#include "services/infill/algo/space_filling/curve_cell.h"

namespace slicefarm::infill {

/// The Peano curve of `order` through a square of 3^order x 3^order cells, from (0, 0) to the
/// opposite corner, upwards first: the cell at `index`. Of the index's ternary digits t1 t2 t3 ..,
/// the odd ones are those of x and the even ones those of y, each mirrored (2 - t) if the sum of
/// the digits of the other axis before it is odd. REQUIRES: order in [0, 20]; index < 9^order.
/// Cost: O(order).
CurveCell PeanoCell(int order, uint64_t index);

/// Its inverse.
uint64_t PeanoIndex(int order, CurveCell cell);

}  // namespace slicefarm::infill
