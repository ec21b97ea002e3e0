#pragma once

#include <optional>

#include "common/geometry/skeleton/boundary.h"
#include "common/geometry/skeleton/skeletal_graph.h"

namespace slicefarm {

/// Returns the medial axis of the region of `boundary`, from the Voronoi diagram of its edges.
/// Edges between two features are not divided into chords. Returns nothing if a node has different
/// distances to the features around it, or if the walks around the rings are not closed. Decides
/// exactly only where doubles leave more than 0.1 um open (voronoi_traits.h). Cost: O(n log n) for
/// n edges: about 4 us per edge. Source: Boost.Polygon's Voronoi diagram of segments.
std::optional<SkeletalGraph> VoronoiAxis(const Boundary& boundary);

/// Returns the same, but with the exact numbers of Boost.Polygon: at about twice the cost.
std::optional<SkeletalGraph> ExactVoronoiAxis(const Boundary& boundary);

}  // namespace slicefarm
