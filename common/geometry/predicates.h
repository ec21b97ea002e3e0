#pragma once

#include "common/geometry/point.h"

namespace slicefarm {

/// +1 if a, b, c turn counter-clockwise, -1 if clockwise, 0 if they lie on one line.
/// Exact for all inputs: 128-bit integers where the coordinates allow, wider ones beyond.
int Orientation(Point a, Point b, Point c);

/// True if p lies on the closed segment ab. Exact.
bool OnSegment(Point p, Point a, Point b);

}  // namespace slicefarm
