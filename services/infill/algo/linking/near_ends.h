#pragma once

#include <optional>

#include "services/infill/algo/linking/link_choice.h"

namespace slicefarm::infill {

/// Returns the length in nm of the shortest tree of straight lines between ends of paths that
/// connects all paths; nullopt if a path is a ring. Cost: O(ends + paths^2).
std::optional<double> PathsBetween(const EdgeEnds& ends, const Links& links);

/// Moves loose ends along the boundary, from link to link, to positions near the ends of other
/// paths, and returns the changed links. This reduces the sum of the distances between paths
/// (PathsBetween) and the added length of links. The number of paths stays the same, and links are
/// no longer than `max_link_nm`. Nothing changes if there is only one path, or if there are more
/// than 24 paths. REQUIRES: no path is a ring. Cost: O(paths (ends + paths^2)).
Links BringEndsTogether(const EdgeEnds& ends, Links links, double max_link_nm);

}  // namespace slicefarm::infill
