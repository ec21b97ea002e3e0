#pragma once

#include <algorithm>
#include <limits>

#include "common/geometry/measure.h"
#include "common/geometry/point.h"
#include "common/model/options/ordering_options.h"

namespace slicefarm::ordering {

/// Returns the largest permitted length in nm of a detour from a to b (max_detour_mm,
/// max_detour_ratio); infinity if the options set no limit.
inline double LongestDetour(Point a, Point b, const TravelOptions& options) {
  const double straight = Distance(a, b);
  double longest = std::numeric_limits<double>::infinity();
  if (options.max_detour_mm > 0) longest = straight + options.max_detour_mm * kNmPerMm;
  if (options.max_detour_ratio > 0)
    longest = std::min(longest, straight * (1 + options.max_detour_ratio));
  return longest;
}

}  // namespace slicefarm::ordering
