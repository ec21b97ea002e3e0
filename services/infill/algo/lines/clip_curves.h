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
/// Crossings of curves and the region's edges are decided exactly. The curves are shifted by half a
/// nanometre from the region's grid, so that no curve passes through corners or along edges. Ends
/// are rounded once to nm, and are within 1 nm of the edge. Cost: O(n + m + crossings) for edges of
/// similar length, n points of the region and m points of curves.
std::vector<Piece> ClipCurves(const MultiPolygon& region, std::span<const Curve> curves);

}  // namespace slicefarm::infill
