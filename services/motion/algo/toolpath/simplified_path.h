#pragma once

#include <vector>

#include "common/model/path.h"

namespace slicefarm::motion {

struct SimplifyOptions {
  Coord tolerance_nm = 0;    ///< of places; 0: nothing is simplified
  Coord bead_height_nm = 0;  ///< of the path
  bool keep_arcs = false;    ///< whether all points stay of what an arc may stand for (arc_fit.h)
  /// Share of a path's width by which a bead's may differ, where that is more than the tolerance.
  double width_share = 0;
  bool inside = false;  ///< other beads lie around the path's: nobody sees the edges of short ones
};

struct SimplifiedPath {
  Path path;
  double flow = 1;  ///< by which its beads make the original's plastic
  /// By edge, of a closed path the one back to the start included: whether an arc may stand for it
  /// and its neighbours.
  std::vector<bool> on_arc;
};

/// The path in as few straight beads as possible, each of one width, that begin and end at points
/// of the path or, where it is curved, beside them on the outside: so beads run on either side of
/// a curve, and are longer by 1.4. As they are written, in whole micrometres, and at every place of
/// either:
///   they lie within the tolerance of the path's beads, and these of them;
///   their widths lie within kWidthToleranceNm (divided_path.h) of the path's, on beads longer than
///   kLongBeadNm within kLongWidthToleranceNm, within 5 % on beads shorter than kShortBeadNm, 10 %
///   inside, or within the share of options. An edge on its own may be a bead of the mean width of
///   its ends, however much that changes: DividedByWidth comes first;
///   no bead is more than 5 % shorter than what it stands for, so that nothing that goes to and fro
///   is lost.
/// Ends, the start of a closed path, and corners of more than 30 degrees where beads meet stay in
/// their places, and the plastic of the whole path stays. Of the ways with the fewest beads, it is
/// the one with the least squared deviations of points. Where the width changes, two points in a
/// row are equal; a closed path whose width changes at its start ends there with a point of its
/// own. A path of no length, and a ring that would be less than a triangle, stay as they are.
/// Cost: O(n k) for beads that stand for up to k edges, 256 at most.
/// Source: H. Imai, M. Iri, "Polygonal Approximations of a Curve", Computational Morphology (1988),
/// by cones of directions (W. S. Chan, F. Chin, Int. J. Comput. Geom. Appl. 6, 1996).
SimplifiedPath Simplified(const Path& path, const SimplifyOptions& options);

}  // namespace slicefarm::motion
