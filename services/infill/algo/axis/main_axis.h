#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Which branches of a medial axis are kept.
struct AxisOptions {
  /// A branch is kept if it leads to a circle in the region that stands out of the circle around
  /// the fork it leaves by more than this, and
  double least_nm = 1'000'000;
  /// by more than this share of that circle's radius: branches into the corners of a round outline
  /// are left out, those into a square corner (0.41) are kept.
  double least_share = 0.15;
};

/// The medial axis of an island, less the branches that a small change of its outline makes: lines
/// that meet in forks, where the straightest two are one line. A line that comes back to where it
/// starts repeats its first point. Where no branch is left, as in a disc, a line of 1 um in the
/// middle; where the Voronoi diagram of the outline cannot be trusted, the middle line of its box
/// along the longer side. So there always is an axis.
///
/// A pruned branch counts by how far the part of the region that it stood for reaches out of the
/// circle, also after its fork has been pruned itself.
/// Precision: 20 um. Cost: O(n log n), n points: 5 us each.
/// Source: MakeSkeletalGraph (Boost.Polygon's Voronoi diagram of segments, less its edges that end
/// in reflex corners).
/// REQUIRES: the island's outer ring is not empty.
std::vector<Polyline> MainAxis(const PolygonWithHoles& island, const AxisOptions& options);

}  // namespace slicefarm::infill
