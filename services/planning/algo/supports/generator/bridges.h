#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Dimensions of the beads that overhangs are printed with.
struct BridgeBeads {
  Coord width_nm = 450'000;  ///< width of infill lines; also the distance between the tested lines
  Coord walls_nm = 0;        ///< total thickness of the walls
  Coord longest_nm = 0;      ///< length of the longest bridge; 0: unlimited
};

/// Returns the part of an overhang that bridges span: straight lines and walls from one anchored
/// end to the other.
///
/// - `below`: outlines of the layer below.
/// - `hanging`: the overhang, which is the area that `below` does not cover.
/// - `steep`: part of `hanging` that would need support. A connected piece of `hanging` without
///   steep area is ignored.
///
/// For each connected piece of `hanging` the function tests 36 directions and the directions of its
/// long edges. It takes the direction with the largest area of anchored lines, as the infill stage
/// does. A line is anchored if both its ends are on `below`.
///
/// Along free edges there are walls instead of lines. A straight wall with support at both ends is
/// a bridge. A wall around a hole or along a curve bends in the air and is no bridge. Spans may be
/// of any length up to the longest bridge. Strips narrower than two lines are left out. Cost: O(36
/// n m) for n lines and m edges of the piece.
MultiPolygon BridgesOf(const MultiPolygon& hanging, const MultiPolygon& steep,
                       const MultiPolygon& below, const BridgeBeads& beads);

}  // namespace slicefarm::planning
