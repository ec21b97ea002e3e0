#pragma once

#include <vector>

#include "common/geometry/skeleton/skeletal_graph.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// A place between the walls that is left to the infill covers at least this much: 0.1 mm3 in a
/// layer of 0.2 mm. A bead in a smaller one is a dot, about as long as it is wide.
inline constexpr double kLeastFillNm2 = 0.5 * kNmPerMm * kNmPerMm;

/// By node: whether it lies in a place that is the infill's by its thickness, but too small for it
/// (kLeastFillNm2), while the inner walls on both sides can be widened until they meet there.
/// Never with a single wall: the outer one keeps its width. `edge_counts`: beads across each edge,
/// -1 where its sides do not face each other. What corners of the outline face is taken as beside
/// a straight edge, which makes it look larger by less than half. Cost: O(n).
std::vector<char> SmallFills(const BeadingStrategy& strategy, const SkeletalGraph& graph,
                             const std::vector<int>& edge_counts);

}  // namespace slicefarm::beading
