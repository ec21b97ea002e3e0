#pragma once

#include "common/geometry/offset/offset.h"
#include "common/geometry/polygon.h"

namespace slicefarm::internal {

/// The curve of a ring's edges, moved `distance_nm` to their right and joined where they meet.
/// Where they close in on a corner, the curve goes by way of the corner itself, so that loops there
/// turn the other way: what it winds around a positive number of times is the ring's offset. Empty
/// where fewer than three points differ from the one before.
///
/// The same curve as ClipperOffset 6.4.2's, whose rules these are (Angus Johnson, Boost licence),
/// with functions of portable_math.h in place of libm's.
Polygon OffsetCurve(const Polygon& ring, double distance_nm, const OffsetOptions& options);

}  // namespace slicefarm::internal
