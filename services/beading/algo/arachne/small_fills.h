#pragma once

#include <vector>

#include "common/geometry/skeleton/skeletal_graph.h"
#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Smallest area between the walls that gets infill: 0.1 mm3 in a layer of 0.2 mm. A bead in a
/// smaller area would be a dot, about as long as it is wide.
inline constexpr double kLeastFillNm2 = 0.5 * kNmPerMm * kNmPerMm;

/// Returns for each node 1 if it is in a small fill, else 0. A small fill is a connected area that
/// is thick enough for infill but smaller than kLeastFillNm2. In addition, the inner walls of both
/// sides must be able to grow until they meet. With one wall per side there is no small fill,
/// because the outer wall keeps its width.
///
/// `edge_counts`: number of beads across each edge; -1 if the edge is not central. At corners of
/// the outline the area is computed as if the outline were straight, which overestimates it by less
/// than half. Cost: O(n), n edges.
std::vector<char> SmallFills(const BeadingStrategy& strategy, const SkeletalGraph& graph,
                             const std::vector<int>& edge_counts);

}  // namespace slicefarm::beading
