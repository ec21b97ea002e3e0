#pragma once

#include <vector>

#include "services/beading/algo/arachne/bead_counts.h"

namespace slicefarm::beading {

/// Smallest number of beads at which the neighbours of the middle bead are inner beads. With fewer
/// beads these neighbours are the outermost beads, which must keep their width.
inline constexpr int kLeastInnerMiddle = 5;

/// Returns the number of beads along each edge after merging. `counts`: numbers that follow from
/// the thickness of each edge; -1: the edge is not central. A stretch (connected edges with the
/// same number) gets another number if it is not worth the transitions at its ends, or not worth a
/// middle bead. Cost: O(n log n), n edges.
std::vector<int> MergedCounts(const BeadingStrategy& strategy, const CountOptions& options,
                              const SkeletalGraph& graph, std::vector<int> counts);

}  // namespace slicefarm::beading
