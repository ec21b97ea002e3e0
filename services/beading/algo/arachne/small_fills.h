#pragma once

#include <vector>

#include "common/geometry/skeleton/skeletal_graph.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Smallest area between the walls that is left to the infill: 0.1 mm3 in a layer of 0.2 mm. A bead
/// in a smaller area is a dot, about as long as it is wide.
inline constexpr double kLeastFillNm2 = 0.5 * kNmPerMm * kNmPerMm;

/// Returns for each node if it is in a small fill. This is a part that is thick enough for infill,
/// but has an area below kLeastFillNm2, and the inner walls of both sides can be widened until they
/// meet. With a single wall there is no small fill: the outer wall keeps its width.
///
/// `edge_counts`: number of beads across each edge, -1 if its sides do not face each other. The
/// area opposite corners of the outline is computed as if the outline were straight, which gives
/// less than half too much. Cost: O(n), n edges.
std::vector<char> SmallFills(const BeadingStrategy& strategy, const SkeletalGraph& graph,
                             const std::vector<int>& edge_counts);

}  // namespace slicefarm::beading
