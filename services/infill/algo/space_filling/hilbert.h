#pragma once

#include <cstdint>

#include "services/infill/algo/space_filling/curve_cell.h"

namespace slicefarm::infill {

/// The Hilbert curve of `order` through a square of 2^order x 2^order cells, from (0, 0) to
/// (2^order - 1, 0): the cell at `index`, by a table of four orientations. REQUIRES: order in
/// [0, 31]; index < 4^order. Cost: O(order).
CurveCell HilbertCell(int order, uint64_t index);

/// Its inverse, by reflected Gray code: two bits of the index are 3x ^ y of the quadrant, and what
/// is inside the quadrant is turned to the first one's orientation.
uint64_t HilbertIndex(int order, CurveCell cell);

}  // namespace slicefarm::infill
