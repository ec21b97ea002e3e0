#pragma once

#include "common/geometry/offset/offset.h"
#include "common/geometry/polygon.h"

namespace slicefarm::internal {

/// Returns the curve that results if each edge of a ring moves `distance_nm` to its right. Where
/// two edges move apart at a corner, a join connects them (OffsetOptions::join). Where they move
/// across each other, the curve goes from one edge to the corner and then to the other edge. This
/// makes a loop with the opposite direction. The offset of the ring is the region in which the
/// curve has a positive winding number. The curve is empty if the ring has fewer than three points,
/// not counting repetitions of the previous point.
///
/// The function follows the rules of ClipperOffset 6.4.2 (Angus Johnson, Boost licence) and gives
/// the same result. It uses portable_math.h instead of libm.
Polygon OffsetCurve(const Polygon& ring, double distance_nm, const OffsetOptions& options);

}  // namespace slicefarm::internal
