#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Lines at distances phase + k pitch, k = 0, 1, ..., from the main lines of each island's medial
/// axis (MainAxis), cut by the region. The lines follow the region's limbs and lead into its
/// corners, split and merge where the axis forks, and end at walls. Spokes (AxisSpokes) join the
/// axis to each wall that it does not reach itself. Therefore no line is a ring between walls
/// without contact to a wall.
///
/// Density: the distance d to any fixed set has |grad d| = 1. The length of {d = phase + k pitch}
/// in any part of the region is therefore the part's area / pitch, on average over the phase
/// (coarea formula). The phase decreases with the height: lines begin at the walls, lean inwards by
/// 45 degrees, and each pair merges on the axis. While the two lines of a pair would overlap
/// (closer than a spacing), one line on the axis replaces both. After they have met, this line
/// continues for an equal height, which gives the same length.
///
/// Source: the family {d(x, axis) = k pitch} of offsets from the medial axis. With a constant phase
/// its density would change by whole lines; the moving phase corrects this. Lines at equal
/// distances from the boundary are `concentric` and `fermat`: they follow walls and have no ends at
/// them. The lines follow the region and do not depend on the origin or on `angle_rad`.
MakePattern MedialAxis;

}  // namespace slicefarm::infill
