#pragma once

#include "common/geometry/point.h"

namespace slicefarm::planning::support {

/// Heights that differ by less are the same.
inline constexpr Coord kSameHeightNm = 1'000;
/// Regions with less are no regions: no bead fits in.
inline constexpr double kLeastRegionNm2 = 0.02e12;

/// For so many layers from its top down a contact has its exact outline: there the part is so near
/// that the edges of pixels would look like contacts at the wrong distance. Then its pixels go on.
inline constexpr int kExactLayers = 4;

}  // namespace slicefarm::planning::support
