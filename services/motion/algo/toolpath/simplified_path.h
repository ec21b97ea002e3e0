#pragma once

#include <vector>

#include "common/model/path.h"

namespace slicefarm::motion {

/// Limits for Simplified.
struct SimplifyOptions {
  Coord tolerance_nm = 0;    ///< largest distance from the path; 0: the path is not simplified
  Coord bead_height_nm = 0;  ///< bead height of the path
  bool keep_arcs = false;    ///< keeps all points of pieces that an arc may replace (arc_fit.h)
  /// Largest relative difference between a bead's width and the path's width. Used if it allows
  /// more than the usual tolerance.
  double width_share = 0;
  /// True if other beads surround the path, so that the steps between short beads are invisible.
  bool inside = false;
};

/// Result of Simplified.
struct SimplifiedPath {
  Path path;
  /// factor for the path's flow that keeps the amount of plastic of the original path
  double flow = 1;
  /// True for each edge that may be part of an arc; indexed by edge. A closed path also has the
  /// edge from the last point to the first.
  std::vector<bool> on_arc;
};

/// Returns the path with as few straight beads as possible, each of one width. Beads begin and end
/// at points of the path. On a curve they may also end slightly outside of it. So the beads deviate
/// to both sides of the curve, and are 1.4 times as long as chords between its points.
///
/// The result in whole micrometres meets these conditions at every point:
/// - The beads are within the tolerance of the path's beads, and the path's beads are within the
///   tolerance of them.
/// - Widths are within kWidthToleranceNm (divided_path.h) of the path's.
/// - On beads longer than kLongBeadNm, widths are within kLongWidthToleranceNm.
/// - On beads shorter than kShortBeadNm, widths are within 5 %, or 10 % with `inside`. The option
///   width_share allows more.
/// - A single edge may always be a bead with the mean width of its ends. DividedByWidth runs first,
///   so this mean is close enough.
/// - No bead is more than 5 % shorter than the replaced path, so that back-and-forth moves are not
///   lost.
///
/// Some points are never moved: ends, the start of a closed path, and corners of more than 30
/// degrees between beads. The plastic of the whole path stays the same. Of the solutions with the
/// fewest beads, the result has the smallest sum of squared deviations of points.
///
/// Where the width changes, two consecutive points are equal. If the width of a closed path changes
/// at its start, the path ends there with an additional point. A path without length, and a ring
/// that would become less than a triangle, are returned unchanged. Cost: O(n k) for n points, and
/// beads that replace up to k edges, 256 at most. Source: H. Imai, M. Iri, "Polygonal
/// Approximations of a Curve", Computational Morphology (1988), by cones of directions (W. S. Chan,
/// F. Chin, Int. J. Comput. Geom. Appl. 6, 1996).
SimplifiedPath Simplified(const Path& path, const SimplifyOptions& options);

}  // namespace slicefarm::motion
