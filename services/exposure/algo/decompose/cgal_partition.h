#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "common/model/options/exposure_options.h"

namespace slicefarm::exposure {

/// More corners than these take kOptimal minutes.
inline constexpr size_t kMaxOptimalCorners = 300;

/// The convex partition of a simple counter-clockwise polygon by CGAL, checked: pieces are convex
/// and have the polygon's area. CGAL 5.5's optimal one is not always.
///
/// kYMonotone: its y-monotone parts, each cut by its approximate partition.
///
/// REQUIRES: method is not kBian; coordinates within +-2^52.
/// Errors:   REQUEST_TOO_LARGE for kOptimal with over kMaxOptimalCorners; INTERNAL where CGAL's
///           pieces are wrong.
absl::StatusOr<std::vector<Polygon>> CgalPartition(const Polygon& polygon, DecomposeMethod method);

}  // namespace slicefarm::exposure
