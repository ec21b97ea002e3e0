#pragma once

#include <vector>

#include "services/infill/algo/space_filling/curve_cell.h"

namespace slicefarm::infill {

/// Closed curves through all cells of a square of 2s x 2s cells, from each cell to one beside it:
/// four space-filling curves of s x s cells, one after another around the middle.

/// s = 2^order: Moore's curve. Cells in order; the first is beside the last.
std::vector<CurveCell> ClosedHilbert(int order);

/// s = 3^order.
std::vector<CurveCell> ClosedPeano(int order);

}  // namespace slicefarm::infill
