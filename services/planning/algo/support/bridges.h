#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// What of an overhang straight lines span from one anchored end to the other.
///
/// hanging:   what lies beyond the layer below
/// steep:     what of it would need support; only parts of `hanging` with something steep are
///            looked at
/// below:     the layer below
/// width_nm:  of a line; lines are tried this far apart
///
/// For each connected part of `hanging` one direction is chosen of 36 and those of its long edges:
/// the one whose anchored lines cover most (as infill does it). A line is anchored where it ends on
/// `below`. Spans may be of any length, as in PrusaSlicer. Strips narrower than two lines are left
/// out.
/// Cost: O(36 * lines * edges of the part).
MultiPolygon BridgesOf(const MultiPolygon& hanging, const MultiPolygon& steep,
                       const MultiPolygon& below, Coord width_nm);

}  // namespace slicefarm::planning
