#pragma once

#include "services/infill/algo/linking/link_choice.h"

namespace slicefarm::infill {

/// Links each end to one neighbour along its ring: every second edge part is a link. Of the two
/// possible choices for a ring, the one with fewer too long parts is used, then the shorter one.
/// The pieces then form rings, into which SplicedPaths can insert crossing paths. An end stays
/// loose if its edge part is longer than `max_link_nm`, and so does one end of a ring with an odd
/// number of ends. Cost: O(k), k ends.
Links LinkAllEnds(const EdgeEnds& ends, double max_link_nm);

}  // namespace slicefarm::infill
