#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Returns the shape moved by `by`.
Polygon Moved(Polygon ring, Point by);
/// Returns the islands moved by `by`.
MultiPolygon Moved(MultiPolygon polygons, Point by);

}  // namespace slicefarm
