#pragma once

#include "common/geometry/offset/offset.h"
#include "common/geometry/polygon.h"

namespace slicefarm::internal {

/// Returns the curve of a ring's edges after they move `distance_nm` to their right, with joins
/// where they meet. At a corner that the edges move towards, the curve passes through the corner
/// itself, so that loops at this corner have the opposite direction. The offset of the ring is the
/// region in which the curve has a positive winding number. The curve is empty if the ring has
/// fewer than three points that differ from the point before them.
///
/// The function follows the rules of ClipperOffset 6.4.2 (Angus Johnson, Boost licence) and gives
/// the same result. It uses portable_math.h instead of libm.
Polygon OffsetCurve(const Polygon& ring, double distance_nm, const OffsetOptions& options);

}  // namespace slicefarm::internal
