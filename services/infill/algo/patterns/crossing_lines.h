#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Families of lines that cross. Each has the pitch times their number, so that together they come
/// to 1 / pitch, exactly.

/// Two directions, at right angles.
MakePattern Grid;
/// Three directions, 60 degrees apart, that meet in points.
MakePattern Triangles;
/// The same, the third direction half a pitch aside: hexagons with triangles around them.
MakePattern Stars;
/// The section of the planes x, y, z = i d of cubes that stand on a corner: three directions, each
/// moving sideways by height / sqrt 2.
MakePattern Cubic;

}  // namespace slicefarm::infill
