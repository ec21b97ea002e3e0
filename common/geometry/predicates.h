#pragma once

#include "common/geometry/point.h"

namespace slicefarm {

/// Returns +1 if the path a, b, c bends counter-clockwise, -1 if clockwise, 0 if the points are on
/// one line. Exact for all inputs: uses 128-bit integers where the coordinates allow, and wider
/// integers for larger coordinates.
int Orientation(Point a, Point b, Point c);

/// Returns true if p is on the closed segment ab. Exact.
bool OnSegment(Point p, Point a, Point b);

}  // namespace slicefarm
