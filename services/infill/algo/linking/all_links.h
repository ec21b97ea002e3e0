#pragma once

#include "services/infill/algo/linking/link_choice.h"

namespace slicefarm::infill {

/// Links each end to a neighbour along the edge, by every second stretch of each ring: those that
/// are shorter together. So the pieces become rings, which paths that cross them can take in
/// (SplicedPaths). Ends beside a stretch longer than `max_link_nm`, and one of an odd number, may
/// stay loose. Cost: O(k).
Links LinkAllEnds(const EdgeEnds& ends, double max_link_nm);

}  // namespace slicefarm::infill
