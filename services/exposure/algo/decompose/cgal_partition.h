#pragma once

#include <optional>
#include <vector>

#include "common/geometry/polygon.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {

/// Largest number of corners for kOptimal. With more corners, kOptimal takes minutes.
inline constexpr size_t kMaxOptimalCorners = 300;

/// Returns CGAL's convex partition of a counter-clockwise polygon. Checks that the pieces are
/// convex and have the polygon's area. Returns nullopt in these cases:
/// - The polygon touches or crosses itself, because CGAL may crash.
/// - The method is kOptimal and the polygon has more than kMaxOptimalCorners corners.
/// - CGAL's result is wrong, which happens with the optimal partition of CGAL 5.5.
///
/// With kYMonotone, the polygon is first divided into y-monotone parts. CGAL's approximate
/// partition then cuts each part.
///
/// REQUIRES: method is not kBian; coordinates within +-2^52.
std::optional<std::vector<Polygon>> CgalPartition(const Polygon& polygon, DecomposeMethod method);

}  // namespace slicefarm::exposure
