#pragma once

#include "common/geometry/point.h"

namespace slicefarm::planning::support {

/// Heights that differ by less are the same.
inline constexpr Coord kSameHeightNm = 1'000;
/// Regions with less are no regions: no bead fits in.
inline constexpr double kLeastRegionNm2 = 0.02e12;

}  // namespace slicefarm::planning::support
