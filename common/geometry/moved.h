#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm {

/// The same shape `by` farther.
Polygon Moved(Polygon ring, Point by);
MultiPolygon Moved(MultiPolygon polygons, Point by);

}  // namespace slicefarm
