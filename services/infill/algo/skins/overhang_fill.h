#pragma once

#include "common/model/layers/layer.h"

namespace slicefarm::infill {

/// Parameters of FillOverhang.
struct OverhangFill {
  Coord width_nm = 450'000;
  Coord height_nm = 200'000;
  /// Distance by which lines may be nearer to the region's boundary than half a spacing.
  Coord overlap_nm = 0;
};

/// Fills a region that bridges cannot span, outwards from its supported part. `below`: the area
/// that supports it. All points of a line have the same distance from `below`. Lines are printed in
/// the order of this distance, the smallest first. So each line has a printed line beside it, from
/// the boundary of `below` to the far end of the region. Lines with ends near each other become one
/// path, back and forth. The group keeps its order. Returns an empty group if nothing supports the
/// region.
///
/// Cost: one offset of the supporting area per line, O(n log n) each, n points. Source: the effect
/// is like PrusaSlicer's "extra perimeters on overhangs" and S. McCulloch's arc overhangs.
FillGroup FillOverhang(const PolygonWithHoles& region, const MultiPolygon& below,
                       const OverhangFill& fill);

}  // namespace slicefarm::infill
