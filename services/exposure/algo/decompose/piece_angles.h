#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// The least angle inside a convex polygon, in degrees.
double LeastAngleDeg(const Polygon& piece);

}  // namespace slicefarm::exposure
