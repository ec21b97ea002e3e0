#pragma once

#include <span>
#include <vector>

#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

/// Line of a pattern, not yet cut to a region.
struct Curve {
  Polyline points;  ///< neighbouring points differ; a closed curve does not repeat its first point
  bool closed = false;
};

/// Returns the parts of curves inside a region, curve by curve.
///
/// Crossings of curves and the region's edges are decided exactly. For these decisions, the curves
/// are shifted by less than a nanometre, so that no curve passes through corners or along edges.
/// Ends are rounded once to nm, and are within 1 nm of the edge. Cost: O(n + m + crossings) for
/// edges of similar length, n points of the region and m points of curves.
std::vector<Piece> ClipCurves(const MultiPolygon& region, std::span<const Curve> curves);

}  // namespace slicefarm::infill
