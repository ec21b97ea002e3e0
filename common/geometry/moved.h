#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Returns the ring moved by the vector `by`.
Polygon Moved(Polygon ring, Point by);
/// Returns the islands moved by the vector `by`.
MultiPolygon Moved(MultiPolygon polygons, Point by);

}  // namespace slicefarm
