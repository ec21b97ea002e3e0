#pragma once

#include "common/model/path.h"

namespace slicefarm::motion {

/// How far a simplified bead's width may lie from the original's at any place.
inline constexpr Coord kWidthToleranceNm = 25'000;

struct SimplifiedPath {
  Path path;
  double flow = 1;  ///< by which its beads make the original's plastic
};

/// The path in as few straight beads as possible, each of one width, from some of the path's points
/// to others. As they are written, in whole micrometres, and at every place of either:
///   they lie within `tolerance_nm` of the path's beads, and these of them;
///   their widths lie within kWidthToleranceNm of the path's, each edge's the mean of its ends;
///   no bead is more than 5 % shorter than what it stands for, so that nothing that goes to and fro
///   is lost.
/// Ends, and the start of a closed path, stay, and the plastic of the whole path at this height of
/// bead does; of the ways with the fewest beads, it is the one with the least squared deviations
/// of points. Where the width changes, two points in a row are equal; a closed path that changes
/// it at its start ends there, explicitly. A path of no length, and a ring that would be less than
/// a triangle, stay as they are.
/// Cost: O(n k) for beads of up to k points, which are no more than 256.
/// Source: H. Imai, M. Iri, "Polygonal Approximations of a Curve", Computational Morphology (1988),
/// with cones of directions after Chan and Chin (1996), and the width as a third coordinate.
SimplifiedPath Simplified(const Path& path, Coord tolerance_nm, Coord bead_height_nm);

}  // namespace slicefarm::motion
