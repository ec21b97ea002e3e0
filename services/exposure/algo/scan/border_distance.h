#pragma once

#include "common/geometry/polygon.h"
#include "services/exposure/algo/scan/convex_ring.h"

namespace slicefarm::exposure {

/// From a place, in or out, to the region's border, in nm. Cost: O(corners).
double DistanceToBorder(PlaneVector place, const MultiPolygon& region);

/// Whether a place is in the region, and no nearer to its border than that. Cost: O(corners).
bool IsWithin(PlaneVector place, double distance_nm, const MultiPolygon& region);

}  // namespace slicefarm::exposure
