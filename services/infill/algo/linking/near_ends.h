#pragma once

#include <optional>

#include "services/infill/algo/linking/link_choice.h"

namespace slicefarm::infill {

/// Length in nm of the shortest tree of ways between the ends of paths; none if one is a ring.
/// Cost: O(ends + paths^2).
std::optional<double> WaysBetween(const EdgeEnds& ends, const Links& links);

/// Moves loose ends along the edge, from link to link, to where other paths end: the ways between
/// paths (WaysBetween) and the links together become shorter. Paths stay as many, links no longer
/// than `max_link_nm`. Nothing moves where paths are one, or more than a few ten.
/// REQUIRES: no path is a ring. Cost: O(paths (ends + paths^2)).
Links BringEndsTogether(const EdgeEnds& ends, Links links, double max_link_nm);

}  // namespace slicefarm::infill
