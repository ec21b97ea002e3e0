#pragma once

#include <vector>

#include "services/beading/algo/arachne/bead_counts.h"

namespace slicefarm::beading {

/// Smallest odd number of beads at which the neighbours of the middle bead are not the outermost
/// beads. The width of outermost beads must not change.
inline constexpr int kLeastInnerMiddle = 5;

/// Returns the number of beads along each edge after merging; -1 for edges that are not central.
/// `counts`: for each edge, the number that follows from its thickness; -1 if the edge is not
/// central. A span is a set of connected central edges with the same number. A span gets the
/// number of a neighbouring span if this changes widths little, or if the span is too short
/// for its half of the transition. Middle beads shorter than about 1 mm are removed. Cost: O(n log
/// n), n edges.
std::vector<int> MergedCounts(const BeadingStrategy& strategy, const CountOptions& options,
                              const SkeletalGraph& graph, std::vector<int> counts);

}  // namespace slicefarm::beading
