#pragma once

#include <vector>

#include "services/infill/algo/space_filling/curve_cell.h"

namespace slicefarm::infill {

// Closed curves through all cells of a square of 2s x 2s cells. Each step leads to a neighbouring
// cell. Four space-filling curves of s x s cells each follow each other around the middle.

/// Returns the cells of Moore's curve in order, with s = 2^order. The last cell is beside the
/// first.
std::vector<CurveCell> ClosedHilbert(int order);

/// Returns the cells of the closed Peano curve in order, with s = 3^order.
std::vector<CurveCell> ClosedPeano(int order);

}  // namespace slicefarm::infill
