#pragma once

#include <vector>

#include "services/beading/algo/arachne/bead_counts.h"
#include "services/beading/algo/arachne/node_beading.h"

namespace slicefarm::beading {

/// Returns the beads at each node of the graph.
///
/// At nodes with a decided number of beads (BeadCount), the strategy lays out the beads. From every
/// other node, the steepest path towards larger radii leads to a decided node, and the node copies
/// the beads of this decided node. So beads keep their distance from the outline.
///
/// A node may also have a path towards smaller radii to a decided node. Then the beads of the node
/// are a blend: within `transition_length_nm` the beads change from the layout of the smaller
/// decided node to the layout of the larger one. Edges are split where a blend ends; `counts` and
/// `central` grow with them.
///
/// Cost: O(n log n), n nodes. Source: Kuipers et al. 2020, section 3.4.
std::vector<NodeBeading> BeadingField(const BeadingStrategy& strategy, double transition_length_nm,
                                      SkeletalGraph& graph, std::vector<BeadCount>& counts,
                                      std::vector<char>& central);

}  // namespace slicefarm::beading
