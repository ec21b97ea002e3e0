#pragma once

#include <cstdint>

#include "common/geometry/polygon.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {

/// Returns a contour as a closed line (its first point is repeated at the end). `start` decides
/// where the line begins:
///   kScattered  at the fraction `share` of the contour's length, in [0, 1);
///   kNearest    at the corner nearest to `at`;
///   kRear       at the corner with the largest y, and of these the one with the largest x.
/// If several corners are tied, the first one is chosen. The contour's shape does not change except
/// for rounding. Cost: O(corners). REQUIRES: at least three corners.
Polyline StartedContour(const Polygon& ring, ContourStart start, double share, Point at);

}  // namespace slicefarm::exposure
