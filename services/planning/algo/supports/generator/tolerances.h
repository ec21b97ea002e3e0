#pragma once

#include "common/geometry/point.h"

namespace slicefarm::planning::support {

/// Difference below which two heights count as equal.
inline constexpr Coord kSameHeightNm = 1'000;
/// Smallest area of a region, in nm^2. No bead fits into less.
inline constexpr double kLeastRegionNm2 = 0.02e12;

/// Number of layers, from the top of a column down, in which a contact keeps its exact outline.
/// These layers are so near to the part that a pixel beside the outline would resemble a contact at
/// the wrong distance. In lower layers the contact has the outline of its pixels.
inline constexpr int kExactLayers = 4;

}  // namespace slicefarm::planning::support
