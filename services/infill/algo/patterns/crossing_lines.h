#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Families of lines that cross. Each family has the pitch times the number of families, so that
/// the total length per area is exactly 1 / pitch.

/// Two directions, at right angles.
MakePattern Grid;
/// Three directions, 60 degrees apart, that meet in points.
MakePattern Triangles;
/// Three directions like Triangles, with the third shifted by half a pitch: hexagons with triangles
/// around them.
MakePattern Stars;
/// Section of a stack of cubes that stand on a corner: the planes x, y, z = i d for all integers i.
/// Lines have three directions; each family shifts sideways by height / sqrt 2.
MakePattern Cubic;
/// Section of four planes inclined to four sides, which enclose tetrahedra and tetrahedra with cut
/// corners: two directions at right angles, each a pair of lines that move apart and together by
/// height / sqrt 2 each. Both lines of a pair stay a spacing apart.
MakePattern QuarterCubic;

}  // namespace slicefarm::infill
