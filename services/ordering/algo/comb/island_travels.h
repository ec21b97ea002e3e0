#pragma once

#include <span>
#include <vector>

#include "common/model/layer.h"
#include "common/model/ordering_options.h"
#include "services/ordering/algo/comb/island_edges.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// The ways between the paths of one island, which are printed in this order: one for each path,
/// the first one's straight and in sight.
///
/// A way is hidden if it crosses no outline, no outer wall and no printed bead of a top surface, is
/// not too long, and does not lead to a visible bead, which would begin with a gap.
/// A way that would be hidden if it crossed no wall goes round inside the island where that is no
/// longer than kCrossingNm more: it takes less time than the retraction. With avoid_crossing each
/// way that is not clear of the walls goes round if a detour that is allowed leads there. `budget`:
/// for lines of sight.
std::vector<Travel> TravelsInIsland(const PolygonWithHoles& outline, const IslandEdges& edges,
                                    std::span<const Path> paths, const TravelOptions& options,
                                    WorkBudget& budget);

}  // namespace slicefarm::ordering
