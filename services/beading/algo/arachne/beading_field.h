#pragma once

#include <vector>

#include "services/beading/algo/arachne/bead_counts.h"
#include "services/beading/algo/arachne/node_beading.h"

namespace slicefarm::beading {

/// Returns the beads at each node of the graph.
///
/// At nodes with a decided number of beads (BeadCount), the strategy lays out the beads. Every
/// other node copies the beads of the decided node at which its steepest path towards larger radii
/// ends, so that beads keep their distance from the boundary. A node may also be reached from a
/// decided node with a smaller radius. Then the beads change from the layout of the smaller node to
/// the layout of the larger one within `transition_length_nm`. Edges are split at the end of this
/// transition; `counts` and `central` grow with them.
///
/// Cost: O(n log n), n nodes. Source: Kuipers et al. 2020, section 3.4.
std::vector<NodeBeading> BeadingField(const BeadingStrategy& strategy, double transition_length_nm,
                                      SkeletalGraph& graph, std::vector<BeadCount>& counts,
                                      std::vector<char>& central);

}  // namespace slicefarm::beading
