#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Lines at distances phase + k pitch, k = 0, 1, ..., from the main axis of each island (MainAxis),
/// cut by the region. The lines follow the region's limbs and lead into its corners, split and
/// merge where the axis forks, and end at walls. Spokes (AxisSpokes) join the axis to each wall
/// that the axis does not reach. Therefore every line has an end at a wall, and no line is a free
/// ring between walls.
///
/// Density: the distance d to any fixed set has |grad d| = 1. The length of {d = phase + k pitch}
/// in any part of the region is therefore the part's area / pitch, on average over the phase
/// (coarea formula). The phase decreases with the height: lines begin at the walls, lean inwards by
/// 45 degrees, and each pair merges on the axis. While the two lines of a pair would overlap
/// (closer than a spacing), one line on the axis replaces both. After they have met, this line
/// continues for an equal height, which gives the same length.
///
/// Source: the family {d(x, axis) = k pitch} of offsets from the medial axis. With a constant phase
/// its density would change by whole lines; the moving phase corrects this. In contrast,
/// `concentric` and `fermat` have lines at equal distances from the boundary, which follow the
/// walls and do not end at them. The lines follow the region and do not depend on the origin or on
/// `angle_rad`.
MakePattern MedialAxis;

}  // namespace slicefarm::infill
