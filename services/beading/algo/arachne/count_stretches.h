#pragma once

#include <vector>

#include "services/beading/algo/arachne/bead_counts.h"

namespace slicefarm::beading {

/// Smallest number of beads at which the neighbours of the middle bead are inner beads. With fewer
/// beads these neighbours are the outermost beads, which must keep their width.
inline constexpr int kLeastInnerMiddle = 5;

/// Returns the numbers of beads along the edges after merging. `counts`: numbers by the thickness
/// of each edge (-1: not central). Stretches that are not worth the transitions at their ends, or
/// not worth a middle bead, are removed. Cost: O(n log n).
std::vector<int> MergedCounts(const BeadingStrategy& strategy, const CountOptions& options,
                              const SkeletalGraph& graph, std::vector<int> counts);

}  // namespace slicefarm::beading
