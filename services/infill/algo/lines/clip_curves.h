#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

/// Line of a pattern, before it is cut to a region.
struct Curve {
  Polyline points;  ///< points; neighbours differ
  bool closed = false;
};

/// Returns the parts of curves inside a region, curve by curve.
///
/// Crossings of curves and edges are decided exactly. The curves are shifted by half a nanometre
/// from the region's grid, so that none runs through corners or along edges. Ends are rounded once
/// to nm, and are within 1 nm of the edge. Cost: O(n + m + crossings) for edges of similar size, n
/// of the region and m of curves.
std::vector<Piece> ClipCurves(const MultiPolygon& region, std::span<const Curve> curves);

}  // namespace slicefarm::infill
