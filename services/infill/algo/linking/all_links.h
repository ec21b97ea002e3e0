#pragma once

#include "services/infill/algo/linking/link_choice.h"

namespace slicefarm::infill {

/// Links each end to one neighbour along its ring: every second edge part (EdgeEnds) becomes a
/// link. There are two choices for a ring. The choice with fewer edge parts longer than
/// `max_link_nm` is used; if both have the same number, the choice with shorter links. The pieces
/// then form rings, into which SplicedPaths can insert crossing paths. An end stays loose if its
/// edge part is longer than `max_link_nm`, and so does one end of a ring with an odd number of
/// ends. Cost: O(k), k ends.
Links LinkAllEnds(const EdgeEnds& ends, double max_link_nm);

}  // namespace slicefarm::infill
