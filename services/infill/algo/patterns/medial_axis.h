#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Lines at distances phase + k pitch from the main lines of each island's medial axis (MainAxis),
/// k = 0, 1, ..., cut by the region: they follow its limbs and run into its corners, split and
/// merge where the axis forks, and end at walls: spokes (AxisSpokes) join the axis to each wall that
/// it does not reach itself, so that no line is a ring between walls which holds to none.
///
/// Law: the distance d to any fixed set has |grad d| = 1, so the length of {d = phase + k pitch} in
/// any part of the region is the part's area / pitch on average over the phase (coarea formula).
/// The phase falls by the height: lines begin at the walls, lean inwards by 45 degrees, and each
/// pair merges on the axis. While its two lines would overlap (closer than a spacing) and as long
/// after they met, the axis itself is one line in their place: that is the same length.
///
/// Source: the family {d(x, axis) = k pitch} of offsets from the medial axis; its one phase has a
/// density that jumps by whole lines, which moving it puts right. Lines at equal distances from the
/// boundary are `concentric` and `fermat`: these run along walls, and have no ends there.
/// Not tied to the origin: lines follow the region. `angle_rad` does not matter.
MakePattern MedialAxis;

}  // namespace slicefarm::infill
