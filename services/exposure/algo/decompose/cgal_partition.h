#pragma once

#include <optional>
#include <vector>

#include "common/geometry/polygon.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {

/// More corners than these take kOptimal minutes.
inline constexpr size_t kMaxOptimalCorners = 300;

/// The convex partition of a counter-clockwise polygon by CGAL, checked: pieces are convex and have
/// the polygon's area. nullopt where CGAL has none to offer: for polygons that touch or cross
/// themselves, on which it may crash; for kOptimal with over kMaxOptimalCorners; and where what it
/// returns is wrong, as CGAL 5.5's optimal one is at times.
///
/// kYMonotone: its y-monotone parts, each cut by its approximate partition.
///
/// REQUIRES: method is not kBian; coordinates within +-2^52.
std::optional<std::vector<Polygon>> CgalPartition(const Polygon& polygon, DecomposeMethod method);

}  // namespace slicefarm::exposure
