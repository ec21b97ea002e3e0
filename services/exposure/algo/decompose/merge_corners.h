#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Limits within which a corner counts as straight.
struct MergeLimits {
  double sagitta = 0;  ///< largest distance of the corner from the chord between its two neighbours
  double area = 0;     ///< largest sum of the areas of all triangles that are cut off or filled in
};

/// Removes repeated and straight points, then corners that are nearly straight. A nearly straight
/// corner is within both limits, and the removed triangle contains no other corner. Without this, a
/// tiny reflex corner would cost a cut and leave a sliver beside the cut. Rings without area
/// disappear. Cost: O(n), n points, and O(n) for each removed corner.
MultiPolygon MergeCorners(const MultiPolygon& islands, const MergeLimits& limits);

}  // namespace slicefarm::exposure
