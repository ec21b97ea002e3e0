#pragma once

#include <cstdint>

#include "common/geometry/polygon.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {

/// A contour as a closed line (its first point repeated) that begins where `start` says:
///   kScattered  at `share` of its length, in [0, 1);
///   kNearest    at the corner nearest to `at`;
///   kRear       at the corner with the greatest y, among such with the greatest x.
/// The first of equal corners. Its course stays the same, to a rounding. Cost: O(corners).
/// REQUIRES: three corners or more.
Polyline StartedContour(const Polygon& ring, ContourStart start, double share, Point at);

}  // namespace slicefarm::exposure
