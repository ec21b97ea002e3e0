#pragma once

#include <optional>

#include "common/geometry/skeleton/boundary.h"
#include "common/geometry/skeleton/skeletal_graph.h"

namespace slicefarm {

/// Returns the medial axis of the region of `boundary`. Edges are not divided into chords. They are
/// in the order in which a line that sweeps the plane from left to right passes the discs at their
/// ends, as in a Voronoi diagram by sweeping. Returns nothing in two cases:
/// - Features have so nearly equal distances that doubles cannot tell them apart.
/// - Too many features have nearly the same distance from one place, as in a large disc.
///
/// The function follows each edge of the axis from a convex corner on. An edge between two features
/// ends where the disc that touches both also touches a third feature. That disc is found by
/// shrinking: the feature that is nearest to the centre of a disc gives the next smaller disc,
/// until no feature is within. Only a whole hole can be between two empty discs without touching
/// them; holes are tested by one point each. So every node is proved to be on the axis.
///
/// Cost: O(n log n) for n edges, about 1 us per edge. Source: the shrinking ball of J. Ma, S. W.
/// Bae, S. Choi, "3D medial axis point approximation using nearest neighbors and the normal field",
/// 2012, applied to the edges of a planar region.
std::optional<SkeletalGraph> TraceAxis(const Boundary& boundary);

}  // namespace slicefarm
