#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Returns the smallest inner angle of a convex polygon, in degrees.
double LeastAngleDeg(const Polygon& piece);

/// Returns perimeter^2 / (4 pi area): 1 for a disc, 1.27 for a square.
double ShapeFactor(const Polygon& piece);

}  // namespace slicefarm::exposure
