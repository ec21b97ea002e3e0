#pragma once

#include <vector>

#include "services/beading/algo/arachne/bead_counts.h"
#include "services/beading/algo/arachne/node_beading.h"

namespace slicefarm::beading {

/// The beads at each node of the graph: where their number is decided, what the strategy lays out;
/// elsewhere those of the place that the node leads up to, so that beads keep their distance from
/// the boundary, going over within `transition_length_nm` from those of the place below it, if
/// there is one. Edges are split where that ends; `counts` and `central` grow with them.
/// Cost: O(n log n).
/// Source: Kuipers et al. 2020, section 3.4.
std::vector<NodeBeading> BeadingField(const BeadingStrategy& strategy, double transition_length_nm,
                                      SkeletalGraph& graph, std::vector<BeadCount>& counts,
                                      std::vector<char>& central);

}  // namespace slicefarm::beading
