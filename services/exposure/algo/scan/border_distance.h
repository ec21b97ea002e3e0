#pragma once

#include "common/geometry/polygon.h"
#include "services/exposure/algo/scan/convex_ring.h"

namespace slicefarm::exposure {

/// From a place, in or out, to the region's border, in nm. Cost: O(corners).
double DistanceToBorder(PlaneVector place, const MultiPolygon& region);

}  // namespace slicefarm::exposure
