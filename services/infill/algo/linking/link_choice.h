#pragma once

#include <vector>

#include "services/infill/algo/linking/edge_ends.h"

namespace slicefarm::infill {

/// Choice of links on a region's boundary. Indexed by end: true if the edge part from this end to
/// the next end (EdgeEnds) is a link. No two links have a common end. Links may close paths to
/// rings.
using Links = std::vector<bool>;

/// Returns the end to which `end` is linked, or kNoEnd.
int32_t LinkedTo(const EdgeEnds& ends, const Links& links, int32_t end);

/// Chooses links that join pieces into as few paths as the search finds. A link is an edge part
/// (EdgeEnds) no longer than `max_link_nm`. The shortest edge parts are linked first. Then loose
/// ends are moved along the boundary, from link to link, as long as this joins paths.
///
/// A move takes a loose end e past the link of its neighbours n and p: e is linked with n, and p
/// becomes loose. The move opens a ring or keeps the number of paths. It makes a ring if n and p
/// are in the wrong order; a later move may open this ring. A path can also grow at its loose end:
/// it takes the neighbouring piece from another path, with the remainder of that path, until it
/// meets the other path's loose end. (Both moves are the rotations of Posa's search for Hamiltonian
/// paths, on ends in a cycle.) Cost: O(k log k) for k ends, and up to 400 steps for each end.
Links ChooseLinks(const EdgeEnds& ends, double max_link_nm);

}  // namespace slicefarm::infill
