#pragma once

#include <vector>

#include "services/beading/algo/arachne/bead_counts.h"
#include "services/beading/algo/arachne/node_beading.h"

namespace slicefarm::beading {

/// Returns the beads at each node of the graph.
///
/// At nodes with a decided number, the strategy lays them out. Other nodes take the beads of the
/// decided node to which their path upwards leads, so that beads keep their distance from the
/// boundary. If there is also a decided node below, the beads change from the lower node's to the
/// upper node's layout within `transition_length_nm`. Edges are split at the end of this
/// transition; `counts` and `central` grow with them.
///
/// Cost: O(n log n). Source: Kuipers et al. 2020, section 3.4.
std::vector<NodeBeading> BeadingField(const BeadingStrategy& strategy, double transition_length_nm,
                                      SkeletalGraph& graph, std::vector<BeadCount>& counts,
                                      std::vector<char>& central);

}  // namespace slicefarm::beading
