#pragma once

#include <vector>

#include "services/infill/algo/linking/edge_ends.h"

namespace slicefarm::infill {

/// Parts of a region's edge that are links: for each end, true if the edge part from it to the next
/// end is a link. No two links have a common end, and none joins a path to a ring.
using Links = std::vector<bool>;

/// Returns the end to which `end` is linked, or kNoEnd.
int32_t LinkedTo(const EdgeEnds& ends, const Links& links, int32_t end);

/// Joins pieces to as few paths as the search finds, by edge parts no longer than `max_link_nm`.
/// The shortest edge parts are linked first. Then loose ends are moved along the edge, from link to
/// link, as long as this joins paths.
///
/// A move takes a loose end e past the link of its neighbours n and p: e is linked with n, and p
/// becomes loose. This opens a ring or keeps the number of paths. If n and p are in the wrong
/// order, it makes a ring, which a later move may open. A path can also grow at its loose end: it
/// takes its neighbour from another path, with the rest of that path, until it meets the other
/// path's loose end. (Both moves are the rotations of Posa's search for Hamiltonian paths, on ends
/// in a cycle.) Cost: O(k log k), and up to kWorkPerEnd steps for each end.
Links ChooseLinks(const EdgeEnds& ends, double max_link_nm);

}  // namespace slicefarm::infill
