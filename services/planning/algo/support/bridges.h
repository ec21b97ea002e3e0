#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// What bridges are printed with.
struct BridgeBeads {
  Coord width_nm = 450'000;  ///< of a line; lines are tried this far apart
  Coord walls_nm = 0;        ///< of all the walls around them together
};

/// What of an overhang straight lines and walls span from one anchored end to the other.
///
/// hanging:   what lies beyond the layer below
/// steep:     what of it would need support; only parts of `hanging` with something steep are
///            looked at
/// below:     the layer below
///
/// For each connected part of `hanging` one direction is chosen of 36 and those of its long edges:
/// the one whose anchored lines cover most (as infill does it). A line is anchored where it ends on
/// `below`. Along free edges there are walls instead of lines: those that run straight from hold to
/// hold are bridges, those around holes, or along what is round, turn in the air. Spans may be of any length, as in PrusaSlicer. Strips narrower than two lines are left
/// out.
/// Cost: O(36 * lines * edges of the part).
MultiPolygon BridgesOf(const MultiPolygon& hanging, const MultiPolygon& steep,
                       const MultiPolygon& below, const BridgeBeads& beads);

}  // namespace slicefarm::planning
