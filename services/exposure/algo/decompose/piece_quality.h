#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// The least angle inside a convex polygon, in degrees.
double LeastAngleDeg(const Polygon& piece);

/// Perimeter^2 / (4 pi area): 1 for a disc, 1.27 for a square.
double ShapeFactor(const Polygon& piece);

}  // namespace slicefarm::exposure
