#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

// Families of parallel lines that cross each other. The lines of each family are the pitch times
// the number of families apart, so that the total length per area is exactly 1 / pitch.

/// Two directions, at right angles.
MakePattern Grid;
/// Three directions, 60 degrees apart. The lines of all three meet in points.
MakePattern Triangles;
/// Three directions like Triangles, with the third family shifted by half the distance of its
/// lines. The result is hexagons with triangles around them.
MakePattern Stars;
/// Section of a stack of cubes that stand on a corner, with faces in the planes x, y, z = i d for
/// all integers i. Lines have three directions; each family shifts sideways by height / sqrt 2.
MakePattern Cubic;
/// Section of four families of planes, inclined to four sides, which enclose tetrahedra and
/// tetrahedra with cut corners. Lines have two directions at right angles. Each direction has two
/// families, which move towards each other and apart again, each by height / sqrt 2. Their lines
/// stay at least a spacing apart.
MakePattern QuarterCubic;
/// Section of two families of planes, inclined by two angles. Both families have the same
/// direction. Where they meet, their lines stay a spacing apart.
MakePattern LateralLattice;
/// Section of upright hexagons: single lines, and in every third part of the height pairs of lines
/// that move apart and to their other neighbours. Density: exact over a period in z.
MakePattern LateralHoneycomb;

}  // namespace slicefarm::infill
