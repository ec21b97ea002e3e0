#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

/// A line of a pattern, before it is cut to a region.
struct Curve {
  Polyline points;  ///< neighbours differ
  bool closed = false;
};

/// What is left of curves inside a region, curve by curve.
///
/// Where a curve meets an edge is decided exactly, with curves half a nanometre aside of the
/// region's grid, so that none runs through its corners or along its edges; ends are rounded once
/// to nm, within 1 nm of the edge. Cost: O(n + m + crossings) for edges of like size, n of the region and m of curves.
std::vector<Piece> ClipCurves(const MultiPolygon& region, std::span<const Curve> curves);

}  // namespace slicefarm::infill
