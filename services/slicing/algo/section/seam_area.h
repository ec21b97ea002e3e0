#pragma once

#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "services/slicing/algo/section/regions.h"
#include "services/slicing/algo/section/sweep.h"

namespace slicefarm::slicing {

/// How far around itself a part that is for seams counts: so far that the outline it lies on is in
/// it whatever `edits` did to that, and that a place for a seam is found in the least of paint.
/// PrusaSlicer has 0.35 mm.
Coord SeamReach(const RegionEdits& edits);

/// How far around itself a painted surface counts for supports: neighbouring faces leave no crack,
/// and it reaches outlines that `edits` moved.
Coord SupportReach(const RegionEdits& edits);

/// Of a body: its region, grown. Cost: that of FastOffset.
MultiPolygon AroundBody(const MultiPolygon& region, Coord reach_nm);

/// Of a surface that is not closed, such as a painted one: what lies within reach of the lines that
/// it is cut in, by rectangles around their segments that go beyond the ends. Horizontal faces are
/// never cut. `resolution_nm`: lines are simplified to this. Empty once `cancel` says so. Cost: a union of as many
/// rectangles (UnionOfMany).
MultiPolygon AroundSurface(const Section& cut, Coord reach_nm, Coord resolution_nm,
                           const CancelToken& cancel = {});

}  // namespace slicefarm::slicing
