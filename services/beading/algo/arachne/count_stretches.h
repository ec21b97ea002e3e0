#pragma once

#include <vector>

#include "services/beading/algo/arachne/bead_counts.h"

namespace slicefarm::beading {

/// With fewer beads those beside the middle one are the outermost, whose width is to stay.
inline constexpr int kLeastInnerMiddle = 5;

/// The numbers of beads along the edges, `counts` by their thickness (-1: not central), without
/// stretches that are not worth the transitions at their ends, or a bead along their middle.
/// Cost: O(n log n).
std::vector<int> MergedCounts(const BeadingStrategy& strategy, const CountOptions& options,
                              const SkeletalGraph& graph, std::vector<int> counts);

}  // namespace slicefarm::beading
