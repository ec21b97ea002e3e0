#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Limits below which branches of a medial axis are removed. A branch leads from a fork of the axis
/// to a free end. Each node of the axis is the centre of an inscribed circle.
struct AxisOptions {
  /// The branch is kept if the circle at its free end reaches beyond the circle at the fork by more
  /// than this distance, and also by more than `least_share`.
  double least_nm = 1'000'000;
  /// Smallest distance by which the circle at the free end reaches beyond the fork's circle, as a
  /// share of the radius of the fork's circle. The default removes branches into corners of a round
  /// outline and keeps branches into a square corner (0.41).
  double least_share = 0.15;
};

/// Returns the medial axis of an island without the branches that a small change of the outline
/// creates. The result is lines that meet in forks; at a fork, the straightest pair of branches is
/// one line. A line that returns to its start repeats its first point. If no branch remains, as in
/// a disc, the result is a line of 1 um in the middle. If the Voronoi diagram of the outline is
/// unreliable, the result is the middle line of the bounding box along its longer side. So the
/// result is never empty.
///
/// If pruning turns a fork into the free end of a branch, the farthest circle of the pruned
/// branches counts as the circle at this end. Precision: 20 um. Cost: O(n log n), n points: 5 us
/// each. Source: MakeSkeletalGraph (Boost.Polygon's Voronoi diagram of segments, without the edges
/// that end in reflex corners). REQUIRES: the island's outer ring is not empty.
std::vector<Polyline> MainAxis(const PolygonWithHoles& island, const AxisOptions& options);

}  // namespace slicefarm::infill
