#pragma once

#include <vector>

#include "services/infill/algo/linking/edge_ends.h"

namespace slicefarm::infill {

/// Which stretches of a region's edge are links: by end, whether the stretch from it to the next
/// is. No two links have an end in common, and none joins a path to a ring.
using Links = std::vector<bool>;

/// The end that `end` is linked to, or kNoEnd.
int32_t LinkedTo(const EdgeEnds& ends, const Links& links, int32_t end);

/// Joins pieces to as few paths as it finds, by stretches no longer than `max_link_nm`: the
/// shortest first; then loose ends are moved along the edge, from link to link, for as long as that
/// brings paths together.
///
/// Moving a loose end e past the link of its neighbours n and p, to be linked with n itself, leaves
/// p loose, and opens a ring or leaves the number of paths; if n and p are the wrong way round it
/// makes a ring, which a later move may open. And a path grows at its loose end by taking its
/// neighbour there from another path, with what hangs on it, until it meets that one's loose end.
/// (Both are the rotations of Posa's search for Hamiltonian paths, on ends in a cycle.)
/// Cost: O(k log k), and up to kWorkPerEnd steps for each end.
Links ChooseLinks(const EdgeEnds& ends, double max_link_nm);

}  // namespace slicefarm::infill
