#pragma once

#include <cstdint>

#include "services/infill/algo/space_filling/curve_cell.h"

namespace slicefarm::infill {

/// Returns the cell at `index` of the Hilbert curve of `order`, by a table of four orientations.
/// The curve passes through a square of 2^order x 2^order cells, from (0, 0) to (2^order - 1, 0).
/// REQUIRES: order in [0, 31]; index < 4^order. Cost: O(order).
CurveCell HilbertCell(int order, uint64_t index);

/// Returns the index of a cell (the inverse of HilbertCell), by reflected Gray code. At each level,
/// x and y are the bits of the cell's quadrant, and two bits of the index are 3x ^ y. The inside of
/// the quadrant is then rotated or mirrored to the orientation of the first quadrant.
uint64_t HilbertIndex(int order, CurveCell cell);

}  // namespace slicefarm::infill
