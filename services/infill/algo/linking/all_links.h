#pragma once

#include "services/infill/algo/linking/link_choice.h"

namespace slicefarm::infill {

/// Links each end to a neighbour along the edge, by every second edge part of each ring. Of the two
/// possibilities, the shorter one is used. The pieces then form rings, into which SplicedPaths can
/// insert crossing paths. An end beside an edge part longer than `max_link_nm` may stay loose, and
/// so may one end of an odd number. Cost: O(k).
Links LinkAllEnds(const EdgeEnds& ends, double max_link_nm);

}  // namespace slicefarm::infill
