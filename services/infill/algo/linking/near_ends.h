#pragma once

#include "services/infill/algo/linking/link_choice.h"

namespace slicefarm::infill {

/// Moves loose ends along the edge, from link to link, so that the ways from path to path become
/// shorter: what the shortest tree of ways between paths' ends comes to. Paths stay as many, links no
/// longer than `max_link_nm`. Links stay as they are where paths are one, or more than kMostPaths.
/// REQUIRES: no path is a ring. Cost: O(loose ends (pieces + paths^2)).
Links BringEndsTogether(const EdgeEnds& ends, Links links, double max_link_nm);

}  // namespace slicefarm::infill
