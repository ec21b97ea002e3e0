#pragma once

#include "services/infill/algo/linking/link_choice.h"

namespace slicefarm::infill {

/// A least matching of the ends along the edge: as many pairs of neighbours as can be linked, each
/// end in one at most, by stretches no longer than `max_link_nm` with room for a bead all along;
/// and of all such choices the one whose links are shortest together. Pieces become rings by it,
/// and paths where ends stay loose.
///
/// Which ends may be a pair is a graph that consists of cycles, the rings of the edge: there the
/// recurrence best(i) = max(best(i - 1), best(i - 2) + stretch) finds what Edmonds' algorithm would
/// (the test compares them). Cost: O(k).
Links LeastLinks(const EdgeEnds& ends, double max_link_nm);

}  // namespace slicefarm::infill
