#pragma once

#include "services/infill/algo/linking/link_choice.h"

namespace slicefarm::infill {

/// Returns the best matching of the ends along the region's boundary. The matching links as many
/// pairs of neighbours as possible, each end in at most one pair. A link is an edge part no longer
/// than `max_link_nm` that is free for a bead along its whole length. Of all such matchings, the
/// one with the smallest total length is returned. Pieces become rings, or paths where ends stay
/// loose.
///
/// The possible pairs form a graph of cycles, one per ring of the boundary. On a cycle, the
/// recurrence best(i) = max(best(i - 1), best(i - 2) + edge part) finds the result of Edmonds'
/// algorithm (a test compares the two). Cost: O(k), k ends.
Links LeastLinks(const EdgeEnds& ends, double max_link_nm);

}  // namespace slicefarm::infill
