#pragma once

#include "common/geometry/skeleton/skeletal_graph.h"

namespace slicefarm {

/// Returns `axis` without the edges that start at no node (-1), in the order of a sweep. A line
/// that sweeps the plane from left to right passes the discs at the ends of the edges in this
/// order. Each edge begins with the half-edge to the disc that is passed first. Beads start at the
/// first edges of a graph, and travels between beads are shorter if these are beside each other.
/// Cost: O(n log n), n edges.
SkeletalGraph InSweepOrder(SkeletalGraph axis);

}  // namespace slicefarm
