#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Limits of the branches of a medial axis that are kept.
struct AxisOptions {
  /// A branch leads from a fork to a circle in the region. It is kept if this circle reaches beyond
  /// the fork's circle by more than this distance, and also by more than `least_share`.
  double least_nm = 1'000'000;
  /// Least reach as a share of the fork's radius. Branches into the corners of a round outline are
  /// removed, branches into a square corner (0.41) are kept.
  double least_share = 0.15;
};

/// Returns the medial axis of an island without the branches that a small change of the outline
/// creates. The result is lines that meet in forks; at a fork the straightest two are one line. A
/// line that returns to its start repeats its first point. If no branch is left, as in a disc, the
/// result is a line of 1 um in the middle. If the Voronoi diagram of the outline is not reliable,
/// the result is the middle line of its box along the longer side. So there is always an axis.
///
/// A pruned branch still counts in later steps. When its fork is a branch's end, the reach of this
/// branch includes the pruned part. Precision: 20 um. Cost: O(n log n), n points: 5 us each.
/// Source: MakeSkeletalGraph (Boost.Polygon's Voronoi diagram of segments, without the edges that
/// end in reflex corners). REQUIRES: the island's outer ring is not empty.
std::vector<Polyline> MainAxis(const PolygonWithHoles& island, const AxisOptions& options);

}  // namespace slicefarm::infill
