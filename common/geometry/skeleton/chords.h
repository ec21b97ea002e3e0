#pragma once

#include "common/geometry/skeleton/skeletal_graph.h"

namespace slicefarm {

/// Returns `graph` with chords instead of its curved edges: parabolas between an edge and a corner,
/// and lines between two corners, along which the radius is not linear. Each chord is within the
/// tolerance of the curve, in position and in radius. Cost: O(n), n half-edges of the result.
SkeletalGraph WithChords(SkeletalGraph graph, const SkeletalOptions& options);

}  // namespace slicefarm
