#pragma once

#include "services/infill/algo/linking/link_choice.h"

namespace slicefarm::infill {

/// Returns the best matching of the ends along the region's boundary. A pair consists of
/// neighbouring ends, and each end is in at most one pair. The link of a pair is the edge part
/// between the two ends. It may be at most `max_link_nm` long, and must be free for a bead along
/// its whole length. The matching has as many pairs as possible, and among all such matchings the
/// smallest total length. Pieces become rings, or open paths where ends stay loose.
///
/// The possible pairs form a graph of cycles, one per ring of the boundary. On a cycle, the
/// recurrence best(i) = max(best(i - 1), best(i - 2) + edge part) finds the result of Edmonds'
/// algorithm (a test compares the two). Cost: O(k), k ends.
Links LeastLinks(const EdgeEnds& ends, double max_link_nm);

}  // namespace slicefarm::infill
