#pragma once

#include "common/model/layers/layer.h"

namespace slicefarm::infill {

struct OverhangFill {
  Coord width_nm = 450'000;
  Coord height_nm = 200'000;
  Coord overlap_nm = 0;  ///< how much nearer than half a spacing lines come to the region's edge
};

/// Fills a region that bridges cannot span from what bears it outwards: lines of equal distance
/// from `below`, so that each lies beside one that is printed already, from the edge of the part
/// below to the region's far end. Lines whose ends meet are one path, to and fro. The group keeps
/// its order. Empty if nothing bears the region.
///
/// Cost: an offset of what bears the region for each line of distance, O(n log n) each.
/// Source: PrusaSlicer's "extra perimeters on overhangs" and S. McCulloch's arc overhangs, for what
/// they achieve.
FillGroup FillOverhang(const PolygonWithHoles& region, const MultiPolygon& below,
                       const OverhangFill& fill);

}  // namespace slicefarm::infill
