#pragma once

#include "common/model/layers/layer.h"

namespace slicefarm::infill {

/// Parameters of FillOverhang.
struct OverhangFill {
  Coord width_nm = 450'000;
  Coord height_nm = 200'000;
  /// Distance by which lines are nearer to the region's boundary than half a spacing.
  Coord overlap_nm = 0;
};

/// Fills a region that bridges cannot span, outwards from its supported part. The lines have equal
/// distances from `below`, so that each line is beside a printed line, from the boundary of `below`
/// to the far end of the region. Lines with touching ends become one path, to and fro. The group
/// keeps its order. Returns an empty group if nothing supports the region.
///
/// Cost: one offset of the supporting area per line of distance, O(n log n) each, n points. Source:
/// the effect is like PrusaSlicer's "extra perimeters on overhangs" and S. McCulloch's arc
/// overhangs.
FillGroup FillOverhang(const PolygonWithHoles& region, const MultiPolygon& below,
                       const OverhangFill& fill);

}  // namespace slicefarm::infill
