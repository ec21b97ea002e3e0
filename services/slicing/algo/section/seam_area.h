#pragma once

#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "services/slicing/algo/section/regions.h"
#include "services/slicing/algo/section/sweep.h"

namespace slicefarm::slicing {

/// Returns the distance by which the volume of a seam modifier is grown. The grown volume still
/// covers the outline on which it was painted, even if `edits` moved that outline. So a seam point
/// is found even in a very small painted area. PrusaSlicer uses 0.35 mm.
Coord SeamReach(const RegionEdits& edits);

/// Returns the distance by which the area of a painted surface for supports is grown. The grown
/// area has no cracks between neighbouring faces, and reaches outlines that `edits` moved.
Coord SupportReach(const RegionEdits& edits);

/// Returns the region of a body, grown by `reach_nm`. Cost: the cost of FastOffset.
MultiPolygon AroundBody(const MultiPolygon& region, Coord reach_nm);

/// Returns the area within `reach_nm` of the lines in `cut`, which is the section of an open
/// surface (such as a painted one). The area consists of a rectangle around each segment, which
/// extends beyond the segment's ends. Horizontal faces have no section, so they contribute nothing.
///
/// `resolution_nm`: tolerance for simplifying the lines. The result is empty if `cancel` is set.
/// Cost: UnionOfMany of one rectangle per segment.
MultiPolygon AroundSurface(const Section& cut, Coord reach_nm, Coord resolution_nm,
                           const CancelToken& cancel = {});

}  // namespace slicefarm::slicing
